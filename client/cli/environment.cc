#include "client/cli/environment.h"

#include <cstdlib>
#include <string_view>

namespace celt::cli {
namespace {

std::string Variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

std::string DefaultStateDir() {
  // A relative path is to be ignored, says the XDG base directory specification.
  const std::string state = Variable("XDG_STATE_HOME");
  if (state.starts_with('/')) return state + "/celt";
  return Variable("HOME") + "/.local/state/celt";
}

}  // namespace celt::cli
