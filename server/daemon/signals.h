#pragma once

#include <csignal>

namespace celt::daemon {

/// SIGINT and SIGTERM, held back in this thread and all that it starts until they are waited for.
/// To be made before any other thread.
class TerminationSignals {
 public:
  TerminationSignals();

  /// Waits for the first one and gives its number. The second one then kills, as if nothing were
  /// set up.
  int Await() const;

 private:
  sigset_t signals_;
};

}  // namespace celt::daemon
