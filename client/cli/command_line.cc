#include "client/cli/command_line.h"

#include <algorithm>
#include <utility>

#include "CLI/Config.hpp"
#include "CLI/Formatter.hpp"
#include "absl/strings/str_cat.h"

namespace celt::cli {
namespace {

constexpr char kDescription[] =
    "Dynamics of the Celtic stone, and of other systems with the same methods.";

constexpr char kFooter[] =
    "Data goes to standard output, messages and progress to standard error.\n"
    "Exit codes: 0 done, 1 ended without an answer, 2 wrong command line or specification,\n"
    "3 no server, 130 interrupted.\n\n"
    "Example:\n  celt lyapunov --energy 752 --iterates 20000";

/// The command that was typed, as far as it was understood: where to look for help.
const CLI::App& Deepest(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? app : Deepest(*parsed.front());
}

std::string FullName(const CLI::App& app) {
  if (app.get_parent() == nullptr) return app.get_name();
  return absl::StrCat(FullName(*app.get_parent()), " ", app.get_name());
}

std::string SeeHelp(const CLI::App& app) {
  return absl::StrCat("; see '", FullName(Deepest(app)), " --help'");
}

/// Of an option with too few values or too many, which all take exactly one.
std::string Miscounted(const CLI::App& app, const CLI::ParseError& error) {
  const std::string message = error.what();
  const std::string option = message.substr(0, message.find(':'));
  const CLI::Option* const given = Deepest(app).get_option_no_throw(option);
  const bool twice = given != nullptr && given->count() > 1;
  return absl::StrCat(option, twice ? ": is given more than once" : ": needs a value");
}

absl::Status Explain(const CLI::App& app, const CLI::ParseError& error) {
  // A word that nobody knows explains whatever else is missing.
  const std::vector<std::string> unknown = app.remaining(true);
  if (!unknown.empty()) {
    const std::string& word = unknown.front();
    const char* const what = word.starts_with('-')                      ? "no such option"
                             : Deepest(app).get_subcommands({}).empty() ? "not expected here"
                                                                        : "no such command";
    return absl::InvalidArgumentError(absl::StrCat(word, ": ", what, SeeHelp(app)));
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    return absl::InvalidArgumentError(absl::StrCat(Miscounted(app, error), SeeHelp(app)));
  }
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    return absl::InvalidArgumentError(absl::StrCat(error.what(), SeeHelp(app)));
  }
  return absl::InvalidArgumentError(error.what());
}

}  // namespace

CommandLine::CommandLine() : app_(kDescription, "celt"), analyses_(MakeAnalyses()) {
  app_.footer(kFooter);
  app_.require_subcommand(1);
  app_.set_help_flag("-h,--help", "print this text and exit");
  app_.set_version_flag("--version", "celt " CELT_VERSION, "print the version and exit");
  app_.get_formatter()->column_width(32);
  service_.AddTo(app_);
  for (const auto& analysis : analyses_) Add(app_, MakeCompute(*analysis));
  AddJobs();
  AddServer();
}

void CommandLine::Add(CLI::App& parent, std::unique_ptr<Command> command) {
  CLI::App* const app = command->AddTo(parent);
  service_.AddTo(*app);
  app->callback([this, added = command.get()] { chosen_ = added; });
  commands_.push_back(std::move(command));
}

void CommandLine::AddJobs() {
  CLI::App& jobs = *app_.add_subcommand("jobs", "List, follow, cancel and delete jobs");
  jobs.group("Service")->require_subcommand(1);
  jobs.footer("Example:\n  celt jobs list --server 127.0.0.1:7350");
  Add(jobs, MakeJobsList());
  Add(jobs, MakeJobsGet());
  Add(jobs, MakeJobsWatch());
  Add(jobs, MakeJobsResults(analyses_));
  Add(jobs, MakeJobsCancel());
  Add(jobs, MakeJobsDelete());
}

void CommandLine::AddServer() {
  CLI::App& server = *app_.add_subcommand("server", "Ask the service about itself");
  server.group("Service")->require_subcommand(1);
  server.footer("Example:\n  celt server info");
  Add(server, MakeServerInfo());
}

absl::StatusOr<Command*> CommandLine::Parse(std::vector<std::string> arguments) {
  std::reverse(arguments.begin(), arguments.end());  // as CLI::App::parse wants them
  try {
    app_.parse(std::move(arguments));
  } catch (const CLI::CallForVersion& version) {
    text_ = absl::StrCat(version.what(), "\n");
    return nullptr;
  } catch (const CLI::CallForHelp&) {
    text_ = app_.help();
    return nullptr;
  } catch (const CLI::ParseError& error) {
    return Explain(app_, error);
  }
  return chosen_;
}

}  // namespace celt::cli
