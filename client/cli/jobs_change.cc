#include "absl/strings/str_cat.h"
#include "client/cli/job_command.h"
#include "client/cli/job_printer.h"

namespace celt::cli {
namespace {

ExitCode PrintJob(const Session& session, const absl::StatusOr<v1::Job>& job) {
  if (!job.ok()) return session.Fail(job.status());
  JobPrinter printer(session.format(), session.terminal());
  return session.Written(printer.PrintOne(*job));
}

class Get : public JobCommand {
 public:
  ExitCode Run(const Session& session) override {
    return PrintJob(session, session.client().Get(id(), session.interrupt()));
  }

 private:
  std::string Verb() const override { return "get"; }
  std::string Description() const override { return "Show a job: state, specification, progress"; }
};

class Cancel : public JobCommand {
 public:
  ExitCode Run(const Session& session) override {
    constexpr absl::Duration kPatience = absl::Seconds(10);
    return PrintJob(session, session.client().Cancel(id(), kPatience, session.interrupt()));
  }

 private:
  std::string Verb() const override { return "cancel"; }
  std::string Description() const override { return "Stop a job; its records are kept"; }
};

class Delete : public JobCommand {
 public:
  ExitCode Run(const Session& session) override {
    const absl::Status status = session.client().Delete(id(), session.interrupt());
    return status.ok() ? kDone : session.Fail(status);
  }

 private:
  std::string Verb() const override { return "delete"; }
  std::string Description() const override {
    return "Remove a job with its records and result; prints nothing";
  }
};

}  // namespace

std::unique_ptr<Command> MakeJobsGet() { return std::make_unique<Get>(); }
std::unique_ptr<Command> MakeJobsCancel() { return std::make_unique<Cancel>(); }
std::unique_ptr<Command> MakeJobsDelete() { return std::make_unique<Delete>(); }

}  // namespace celt::cli
