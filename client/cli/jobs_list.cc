#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "client/cli/command.h"
#include "client/cli/job_printer.h"
#include "client/cli/option.h"

namespace celt::cli {
namespace {

constexpr char kGroup[] = "Jobs";
constexpr std::int64_t kLargestPage = 1000;

class List : public Command {
 public:
  CLI::App* AddTo(CLI::App& parent) override {
    CLI::App* const app = parent.add_subcommand("list", "List jobs, the newest first");
    AddChoice(*app, "--state", {"queued", "running", "succeeded", "failed", "cancelled"}, state_,
              {kGroup, "STATE", "queued, running, succeeded, failed or cancelled (default: all)"});
    AddInteger(*app, "--limit", limit_, {kGroup, "N", "at most so many (default: all)"},
               {.lowest = 1});
    app->footer("Example:\n  celt jobs list --state running --server 127.0.0.1:7350");
    return app;
  }

  ExitCode Run(const Session& session) override {
    std::vector<v1::Job> jobs;
    const absl::Status status = Collect(session, jobs);
    if (!status.ok()) return session.Fail(status);
    JobPrinter printer(session.format(), session.terminal());
    return session.Written(printer.Print(jobs));
  }

 private:
  absl::Status Collect(const Session& session, std::vector<v1::Job>& jobs) const {
    v1::ListJobsRequest request;
    if (state_) request.add_states(static_cast<v1::Job::State>(*state_ + v1::Job::STATE_QUEUED));
    std::int64_t left = limit_.value_or(std::numeric_limits<std::int64_t>::max());
    do {
      request.set_page_size(static_cast<std::int32_t>(std::min(left, kLargestPage)));
      const auto page = session.client().List(request, session.interrupt());
      if (!page.ok()) return page.status();
      jobs.insert(jobs.end(), page->jobs().begin(), page->jobs().end());
      left -= page->jobs_size();
      request.set_page_token(page->next_page_token());
    } while (left > 0 && !request.page_token().empty());
    return absl::OkStatus();
  }

  std::optional<int> state_;
  std::optional<std::int64_t> limit_;
};

}  // namespace

std::unique_ptr<Command> MakeJobsList() { return std::make_unique<List>(); }

}  // namespace celt::cli
