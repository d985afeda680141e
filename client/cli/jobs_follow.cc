#include <cstdint>
#include <optional>

#include "absl/time/clock.h"
#include "client/cli/follow.h"
#include "client/cli/job_command.h"
#include "client/cli/job_printer.h"
#include "client/cli/json.h"
#include "client/cli/option.h"
#include "client/cli/progress.h"

namespace celt::cli {
namespace {

class Watch : public JobCommand {
 public:
  ExitCode Run(const Session& session) override {
    // Asked first, so that a server that is not there is not waited for.
    const auto found = session.client().Get(id(), session.interrupt());
    if (!found.ok()) return session.Fail(found.status());
    JobPrinter printer(session.format(), session.terminal());
    ProgressMeter meter;
    absl::Status printed;
    const auto show = [&](const v1::Job& job) {
      if (session.format() != OutputFormat::kTable) printed = printer.Print({job});
      session.terminal().Progress(meter.Line(job, absl::Now()));
      return printed;
    };
    const auto job = session.client().Watch(id(), show, session.interrupt());
    if (!printed.ok()) return session.Written(printed);
    if (!job.ok()) return session.Fail(job.status());
    return End(session, *job);
  }

 private:
  std::string Verb() const override { return "watch"; }
  std::string Description() const override {
    return "Follow a job's state and progress until it ends";
  }

  static ExitCode End(const Session& session, const v1::Job& job) {
    if (session.format() == OutputFormat::kTable) {
      JobPrinter printer(session.format(), session.terminal());
      const absl::Status printed = printer.PrintOne(job);
      if (!printed.ok()) return session.Written(printed);
    }
    return job.state() == v1::Job::STATE_SUCCEEDED ? kDone : kNoAnswer;
  }
};

class Results : public JobCommand {
 public:
  explicit Results(const Analyses& analyses) : analyses_(analyses) {}

  ExitCode Run(const Session& session) override {
    const auto job = session.client().Get(id(), session.interrupt());
    if (!job.ok()) return session.Fail(job.status());
    const Analysis* const analysis = Find(AnalysisField(job->spec()));
    if (analysis == nullptr) {
      return session.Fail(absl::UnimplementedError(
          "the job is of an analysis that this version of celt does not know"));
    }
    return Follow(session, *analysis, *job, {.after = after_.value_or(0), .cancel_on_exit = false});
  }

 private:
  std::string Verb() const override { return "results"; }
  std::string Description() const override {
    return "Print a job's records, live while it runs, then its result";
  }
  void AddOptions(CLI::App& app) override {
    AddInteger(app, "--after", after_,
               {"Jobs", "N", "only records with a larger sequence number (default 0: all)"});
  }

  const Analysis* Find(const std::string& field) const {
    for (const auto& analysis : analyses_) {
      if (analysis->field() == field) return analysis.get();
    }
    return nullptr;
  }

  const Analyses& analyses_;
  std::optional<std::int64_t> after_;
};

}  // namespace

std::unique_ptr<Command> MakeJobsWatch() { return std::make_unique<Watch>(); }
std::unique_ptr<Command> MakeJobsResults(const Analyses& analyses) {
  return std::make_unique<Results>(analyses);
}

}  // namespace celt::cli
