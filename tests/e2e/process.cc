#include "tests/e2e/process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <system_error>

#include "gtest/gtest.h"

namespace celt {
namespace {

using std::chrono::steady_clock;

constexpr auto kPatience = std::chrono::seconds(120);
constexpr int kKilled = 128;

void Check(int error, const std::string& what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

struct Pipe {
  Pipe() { Check(pipe2(ends.data(), O_CLOEXEC) == 0 ? 0 : errno, "pipe"); }
  std::array<int, 2> ends{};
};

std::vector<std::string> MergedEnvironment(const std::map<std::string, std::string>& added) {
  std::vector<std::string> merged;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (!added.contains(text.substr(0, text.find('=')))) merged.push_back(text);
  }
  for (const auto& [name, value] : added) merged.push_back(name + "=" + value);
  return merged;
}

std::vector<char*> Pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

int MillisecondsUntil(steady_clock::time_point deadline) {
  using std::chrono::milliseconds;
  const auto left = std::chrono::ceil<milliseconds>(deadline - steady_clock::now());
  return static_cast<int>(std::max(left, milliseconds::zero()).count());
}

/// Not fork(): a test with gRPC in it has threads, and after a fork only exec is safe.
pid_t Spawn(const std::string& program, std::vector<std::string> arguments,
            std::vector<std::string> environment, const Pipe& out, const Pipe& err) {
  arguments.insert(arguments.begin(), program);
  posix_spawn_file_actions_t actions;
  Check(posix_spawn_file_actions_init(&actions), "posix_spawn_file_actions_init");
  Check(posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0), "open");
  Check(posix_spawn_file_actions_adddup2(&actions, out.ends[1], STDOUT_FILENO), "dup2");
  Check(posix_spawn_file_actions_adddup2(&actions, err.ends[1], STDERR_FILENO), "dup2");
  pid_t pid = -1;
  const int error = posix_spawn(&pid, program.c_str(), &actions, nullptr,
                                Pointers(arguments).data(), Pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  Check(error, program);
  return pid;
}

}  // namespace

Process::Process(const std::string& program, const std::vector<std::string>& arguments,
                 const std::map<std::string, std::string>& environment)
    : name_(program) {
  for (const std::string& argument : arguments) name_ += " " + argument;
  const Pipe out;
  const Pipe err;
  pid_ = Spawn(program, arguments, MergedEnvironment(environment), out, err);
  close(out.ends[1]);
  close(err.ends[1]);
  pipes_ = {out.ends[0], err.ends[0]};
  // The header of glibc 2.36 declares pidfd_open() without C linkage.
  pidfd_ = static_cast<int>(syscall(SYS_pidfd_open, pid_, 0));
  Check(pidfd_ >= 0 ? 0 : errno, "pidfd_open");
}

Process::~Process() {
  if (code_ < 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  for (const int file : pipes_) {
    if (file >= 0) close(file);
  }
  close(pidfd_);
}

std::string Process::ReadLine() {
  const auto deadline = steady_clock::now() + kPatience;
  std::string& text = texts_[0];
  std::size_t end = text.find('\n');
  while (end == std::string::npos && pipes_[0] >= 0 && Take(deadline)) end = text.find('\n');
  const std::string line = text.substr(0, end);
  text.erase(0, end == std::string::npos ? end : end + 1);
  return line;
}

void Process::CloseOutput() {
  close(pipes_[0]);
  pipes_[0] = -1;
}

void Process::Signal(int signal) const { kill(pid_, signal); }

Ended Process::Wait() {
  const auto deadline = steady_clock::now() + kPatience;
  while (Take(deadline)) {
  }
  WaitForExit(deadline);
  return {code_, texts_[0], texts_[1]};
}

bool Process::Take(Deadline deadline) {
  std::array<pollfd, 2> files = {pollfd{pipes_[0], POLLIN, 0}, pollfd{pipes_[1], POLLIN, 0}};
  if (pipes_[0] < 0 && pipes_[1] < 0) return false;
  const int ready = poll(files.data(), files.size(), MillisecondsUntil(deadline));
  if (ready < 0 && errno == EINTR) return true;
  if (ready == 0) Hangs();
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (pipes_[i] >= 0 && files[i].revents != 0 && !TakeFrom(i)) {
      close(pipes_[i]);
      pipes_[i] = -1;
    }
  }
  return true;
}

bool Process::TakeFrom(std::size_t index) {
  std::array<char, 65536> buffer;
  const ssize_t size = read(pipes_[index], buffer.data(), buffer.size());
  if (size > 0) texts_[index].append(buffer.data(), static_cast<std::size_t>(size));
  return size > 0;
}

void Process::WaitForExit(Deadline deadline) {
  if (code_ >= 0) return;
  pollfd exited = {pidfd_, POLLIN, 0};
  if (poll(&exited, 1, MillisecondsUntil(deadline)) == 0) Hangs();
  int status = 0;
  waitpid(pid_, &status, 0);
  code_ = WIFEXITED(status) ? WEXITSTATUS(status) : kKilled + WTERMSIG(status);
}

/// After the kill, the pipes and the wait end by themselves.
void Process::Hangs() {
  ADD_FAILURE() << name_ << " hangs; so far it said\n" << texts_[0] << texts_[1];
  kill(pid_, SIGKILL);
}

}  // namespace celt
