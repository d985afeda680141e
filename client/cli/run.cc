#include "client/cli/run.h"

#include <algorithm>
#include <utility>

#include "client/cli/command_line.h"
#include "client/cli/session.h"

namespace celt::cli {

int Run(const std::vector<std::string>& arguments, const Environment& environment) {
  Terminal terminal(*environment.out, *environment.err, environment.progress_width);
  CommandLine line;
  const auto command = line.Parse(arguments);
  if (!command.ok()) {
    terminal.Say(std::string(command.status().message()));
    return kBadRequest;
  }
  if (*command == nullptr) return terminal.Write(line.text()).ok() ? kDone : kNoAnswer;
  const bool embedded = line.service().Server(environment).empty();
  absl::Status checked = (*command)->Check(embedded);
  if (!checked.ok()) {
    terminal.Say(std::string(checked.message()));
    return ExitCodeOf(checked);
  }
  const auto session =
      Session::Open(line.service(), environment, terminal, (*command)->NeedsPastJobs());
  if (!session.ok()) {
    terminal.Say(std::string(session.status().message()));
    return absl::IsInvalidArgument(session.status()) ? kBadRequest : kNoServer;
  }
  return (*command)->Run(**session);
}

}  // namespace celt::cli
