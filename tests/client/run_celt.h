#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "client/cli/environment.h"

namespace celt {

/// What a run of the command line left.
struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

/// What a run finds around it.
struct Surroundings {
  std::string server = {};  ///< of CELT_SERVER
  std::string token = {};   ///< of CELT_TOKEN
  bool out_is_terminal = false;
  int progress_width = 0;
  std::stop_token interrupt = {};
  cli::StartEmbedded start_embedded = {};  ///< by default it must not be called
};

/// Runs `celt` with these arguments in this process.
Outcome RunCelt(const std::vector<std::string>& arguments, const Surroundings& around = {});

}  // namespace celt
