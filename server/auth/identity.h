#pragma once

#include <string>

namespace celt::auth {

/// Who calls.
struct Identity {
  std::string owner;   ///< of the jobs that they submit
  bool admin = false;  ///< sees everybody's jobs
};

}  // namespace celt::auth
