#pragma once

#include <stop_token>
#include <thread>

namespace celt::cli {

/// Turns SIGINT and SIGTERM into a stop: the first asks for it, a second one, or five seconds
/// without the program's end, end the program at once with exit code 130. Nothing is done in
/// signal handlers: a thread of its own reads the signals (signalfd(2)). SIGPIPE is ignored, a
/// write to a closed pipe fails instead.
///
/// To be made before any other thread, which would otherwise take the signals.
class Signals {
 public:
  Signals();
  ~Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  std::stop_token interrupt() const { return interrupt_.get_token(); }

 private:
  void Run();
  enum class Event { kSignal, kTimeout, kEnd };
  /// The next event; -1 milliseconds is no limit.
  Event Wait(int timeout);

  std::stop_source interrupt_;
  int signals_ = -1;
  int end_ = -1;
  std::thread thread_;
};

}  // namespace celt::cli
