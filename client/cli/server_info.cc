#include <string>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/strip.h"
#include "absl/time/time.h"
#include "client/cli/command.h"
#include "client/cli/csv.h"
#include "client/cli/format.h"
#include "client/cli/json.h"
#include "client/cli/text_table.h"

namespace celt::cli {
namespace {

std::string SystemTable(const v1::SystemInfo& system) {
  TextTable table({"parameter", "default", "unit", "range", ""});
  for (const v1::ParameterInfo& parameter : system.parameters()) {
    table.Add({parameter.name(), Shortest(parameter.default_value()), parameter.unit(),
               parameter.range(), parameter.description()});
  }
  return absl::StrCat("\n", system.name(), ": ", system.description(), "\n   coordinates ",
                      absl::StrJoin(system.coordinates(), ", "), "\n", table.Text());
}

std::string Engines(const v1::GetInfoResponse& info) {
  std::vector<std::string> names;
  for (const int engine : info.engines()) {
    const std::string name = v1::Engine_Name(static_cast<v1::Engine>(engine));
    names.push_back(absl::AsciiStrToLower(absl::StripPrefix(name, "ENGINE_")));
  }
  return absl::StrJoin(names, ", ");
}

/// Empty when there is none.
std::string LimitsTable(const v1::Limits& limits) {
  const std::string computing =
      limits.computing_seconds() > 0 ? Clock(absl::Seconds(limits.computing_seconds())) : "";
  const auto count = [](std::int64_t limit) { return limit > 0 ? Grouped(limit) : ""; };
  TextTable table({"at most", ""});
  bool any = false;
  const auto add = [&](const std::string& what, const std::string& limit) {
    if (limit.empty()) return;
    table.Add({what, limit});
    any = true;
  };
  add("iterates of a job", count(limits.iterates()));
  add("nodes of a sweep", count(limits.nodes()));
  add("records of a job", count(limits.records()));
  add("computing of a job", computing);
  add("unfinished jobs", count(limits.unfinished_jobs()));
  add("  of one owner", count(limits.unfinished_jobs_per_owner()));
  return any ? absl::StrCat("\n", table.Text()) : "";
}

std::string Table(const v1::GetInfoResponse& info) {
  std::string text =
      absl::StrCat("celt ", info.version(), ", engine version ", info.engine_version(), ", ",
                   info.workers(), info.workers() == 1 ? " worker\n" : " workers\n");
  TextTable offers({});
  offers.Add({"computes", absl::StrJoin(info.analyses(), ", ")});
  offers.Add({"by", Engines(info)});
  absl::StrAppend(&text, offers.Text(), LimitsTable(info.limits()));
  for (const v1::SystemInfo& system : info.systems()) absl::StrAppend(&text, SystemTable(system));
  return text;
}

std::string Csv(const v1::GetInfoResponse& info) {
  std::string text = CsvLine({"system", "parameter", "default", "unit", "range", "description"});
  for (const v1::SystemInfo& system : info.systems()) {
    for (const v1::ParameterInfo& parameter : system.parameters()) {
      absl::StrAppend(&text,
                      CsvLine({system.name(), parameter.name(), Shortest(parameter.default_value()),
                               parameter.unit(), parameter.range(), parameter.description()}));
    }
  }
  return text;
}

class ServerInfo : public Command {
 public:
  CLI::App* AddTo(CLI::App& parent) override {
    CLI::App* const app =
        parent.add_subcommand("info", "Versions, what it computes, limits, systems");
    app->footer("Example:\n  celt server info");
    return app;
  }

  bool NeedsPastJobs() const override { return false; }

  ExitCode Run(const Session& session) override {
    const auto info = session.client().Info(session.interrupt());
    if (!info.ok()) return session.Fail(info.status());
    std::string text = ToJson("info", *info) + "\n";
    if (session.format() == OutputFormat::kTable) text = Table(*info);
    if (session.format() == OutputFormat::kCsv) text = Csv(*info);
    return session.Written(session.terminal().Write(text));
  }
};

}  // namespace

std::unique_ptr<Command> MakeServerInfo() { return std::make_unique<ServerInfo>(); }

}  // namespace celt::cli
