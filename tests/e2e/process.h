#pragma once

#include <sys/types.h>

#include <array>
#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace celt {

/// What a process left.
struct Ended {
  int code = -1;  ///< exit code; 128 + signal when a signal ended it
  std::string out;
  std::string err;
};

/// A program started by a test, with pipes on its standard output and error. It is killed with the
/// object. Whatever waits, waits for the process, at most until a deadline that only a hanging
/// program meets: then the test fails and the process is killed.
class Process {
 public:
  /// `environment` is added to that of the test.
  Process(const std::string& program, const std::vector<std::string>& arguments,
          const std::map<std::string, std::string>& environment = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// The next line of standard output, without its end; empty at the end of the output.
  std::string ReadLine();
  /// Closes our end of its standard output, as `head` does when it has enough.
  void CloseOutput();
  pid_t pid() const { return pid_; }
  void Signal(int signal) const;
  /// Waits for its end; all that it wrote and was not read.
  Ended Wait();

 private:
  using Deadline = std::chrono::steady_clock::time_point;
  /// Waits for something to read on either pipe and takes it; false at the end of both.
  bool Take(Deadline deadline);
  bool TakeFrom(std::size_t index);
  void WaitForExit(Deadline deadline);
  void Hangs();

  std::string name_;
  pid_t pid_ = -1;
  int pidfd_ = -1;
  std::array<int, 2> pipes_ = {-1, -1};  // of standard output and standard error; -1: closed
  std::array<std::string, 2> texts_;
  int code_ = -1;
};

}  // namespace celt
