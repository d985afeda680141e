#include "client/cli/job_command.h"

#include "absl/strings/str_cat.h"

namespace celt::cli {

CLI::App* JobCommand::AddTo(CLI::App& parent) {
  CLI::App* const app = parent.add_subcommand(Verb(), Description());
  app->add_option("ID", id_, "of the job, as 'celt jobs list' shows it")->required()->type_name("");
  app->footer(absl::StrCat("Example:\n  celt jobs ", Verb(), " ID --server 127.0.0.1:7350"));
  AddOptions(*app);
  return app;
}

}  // namespace celt::cli
