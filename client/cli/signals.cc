#include "client/cli/signals.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <string_view>
#include <system_error>

#include "client/cli/exit_code.h"

namespace celt::cli {
namespace {

constexpr int kGraceMilliseconds = 5000;

int Checked(int result, const char* what) {
  if (result < 0) throw std::system_error(errno, std::generic_category(), what);
  return result;
}

/// Without destructors, which may be what hangs; the line of progress is not left behind.
[[noreturn]] void ExitAtOnce() {
  constexpr std::string_view kEraseLine = "\r\x1b[K";
  if (isatty(STDERR_FILENO) == 1) {
    static_cast<void>(!write(STDERR_FILENO, kEraseLine.data(), kEraseLine.size()));
  }
  _exit(kInterrupted);
}

}  // namespace

Signals::Signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  signals_ = Checked(signalfd(-1, &set, SFD_CLOEXEC), "signalfd");
  end_ = Checked(eventfd(0, EFD_CLOEXEC), "eventfd");
  thread_ = std::thread([this] { Run(); });
}

Signals::~Signals() {
  const std::uint64_t one = 1;
  static_cast<void>(!write(end_, &one, sizeof one));
  thread_.join();
  close(signals_);
  close(end_);
}

void Signals::Run() {
  if (Wait(-1) != Event::kSignal) return;
  interrupt_.request_stop();
  if (Wait(kGraceMilliseconds) != Event::kEnd) ExitAtOnce();
}

Signals::Event Signals::Wait(int timeout) {
  std::array<pollfd, 2> files = {pollfd{signals_, POLLIN, 0}, pollfd{end_, POLLIN, 0}};
  int ready = 0;
  do {
    ready = poll(files.data(), files.size(), timeout);
  } while (ready < 0 && errno == EINTR);
  if (files[1].revents != 0) return Event::kEnd;
  if (ready <= 0) return Event::kTimeout;
  signalfd_siginfo taken;
  static_cast<void>(!read(signals_, &taken, sizeof taken));
  return Event::kSignal;
}

}  // namespace celt::cli
