#include "absl/strings/str_cat.h"
#include "client/cli/command.h"
#include "client/cli/csv.h"
#include "client/cli/estimate.h"
#include "client/cli/follow.h"
#include "client/cli/json.h"
#include "client/cli/system_options.h"

namespace celt::cli {
namespace {

class Compute : public Command {
 public:
  explicit Compute(Analysis& analysis) : analysis_(analysis) {}

  CLI::App* AddTo(CLI::App& parent) override {
    CLI::App* const app = parent.add_subcommand(analysis_.command(), analysis_.description());
    app->group("Computing");
    app->footer(absl::StrCat("Example:\n  ", analysis_.example()));
    analysis_.AddOptions(*app);
    system_.AddTo(*app);
    app->add_flag("--detach", detach_, "print the id of the job and leave it to the server")
        ->group("Service");
    app->add_flag("--fresh", fresh_, "compute, although the answer may be known already")
        ->group("Service");
    app->add_flag("--dry-run", dry_run_,
                  "only check, and say how much work it is and how long it takes")
        ->group("Service");
    return app;
  }

  absl::Status Check(bool embedded) override {
    if (detach_ && dry_run_) {
      return absl::InvalidArgumentError("--detach: a --dry-run leaves no job");
    }
    if (detach_ && embedded) {
      return absl::InvalidArgumentError(
          "--detach: needs --server HOST:PORT, a job inside this program would end with it");
    }
    request_.set_fresh(fresh_);
    request_.set_validate_only(dry_run_);
    absl::Status filled = system_.Fill(*request_.mutable_spec());
    return filled.ok() ? analysis_.Fill(*request_.mutable_spec()) : filled;
  }

  bool NeedsPastJobs() const override { return false; }

  ExitCode Run(const Session& session) override {
    const auto job = session.client().Submit(request_);
    if (!job.ok()) return session.Fail(job.status());
    if (dry_run_) return PrintEstimate(session, *job);
    if (job->has_estimate()) SayEstimate(session, *job);
    if (detach_) return PrintId(session, job->id());
    if (job->state() == v1::Job::STATE_SUCCEEDED) session.terminal().Say(KnownText(*job));
    // The embedded service ends with this program, and its job waits for the next one.
    const ExitCode code =
        Follow(session, analysis_, *job, {.after = 0, .cancel_on_exit = !session.embedded()});
    return code == kDone ? analysis_.Afterwards(session) : code;
  }

 private:
  /// To who is left alone with a job, or sits before one that takes a while.
  void SayEstimate(const Session& session, const v1::Job& job) const {
    constexpr absl::Duration kWhile = absl::Seconds(3);
    const bool told = session.terminal().shows_progress() && UntilEnd(job.estimate()) > kWhile;
    if (!detach_ && !told) return;
    session.terminal().Say(absl::StrCat("job ", job.id(), " takes ", EstimateText(job.estimate())));
  }

  static ExitCode PrintEstimate(const Session& session, const v1::Job& job) {
    return session.Written(session.terminal().Write(EstimateReport(job, session.format())));
  }

  static ExitCode PrintId(const Session& session, const std::string& id) {
    v1::Job job;
    job.set_id(id);
    std::string text = id + "\n";
    if (session.format() == OutputFormat::kJson) text = ToJson("job", job) + "\n";
    if (session.format() == OutputFormat::kCsv) text = CsvLine({"id"}) + CsvLine({id});
    return session.Written(session.terminal().Write(text));
  }

  Analysis& analysis_;
  SystemOptions system_;
  bool detach_ = false;
  bool fresh_ = false;
  bool dry_run_ = false;
  v1::SubmitJobRequest request_;
};

}  // namespace

std::unique_ptr<Command> MakeCompute(Analysis& analysis) {
  return std::make_unique<Compute>(analysis);
}

}  // namespace celt::cli
