#include "tests/client/run_celt.h"

#include <sstream>

#include "client/cli/run.h"
#include "gtest/gtest.h"

namespace celt {

Outcome RunCelt(const std::vector<std::string>& arguments, const Surroundings& around) {
  std::ostringstream out;
  std::ostringstream err;
  cli::Environment environment;
  environment.out = &out;
  environment.err = &err;
  environment.out_is_terminal = around.out_is_terminal;
  environment.progress_width = around.progress_width;
  environment.server = around.server;
  environment.token = around.token;
  environment.state_dir = "/nonexistent";
  environment.interrupt = around.interrupt;
  environment.start_embedded = around.start_embedded;
  if (!environment.start_embedded) {
    environment.start_embedded = [](const cli::EmbeddedOptions& /*options*/)
        -> absl::StatusOr<std::unique_ptr<cli::EmbeddedService>> {
      ADD_FAILURE() << "the embedded service was started";
      return absl::InternalError("none");
    };
  }
  const int code = cli::Run(arguments, environment);
  return {code, out.str(), err.str()};
}

}  // namespace celt
