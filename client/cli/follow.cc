#include "client/cli/follow.h"

#include <optional>
#include <stop_token>
#include <thread>

#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "client/cli/cancel_on_interrupt.h"
#include "client/cli/progress.h"
#include "client/cli/result_printer.h"

namespace celt::cli {
namespace {

/// Shows the progress of a job, where there is a terminal for it, as long as it lives.
std::jthread ShowProgress(const Session& session, const std::string& id) {
  if (!session.terminal().shows_progress()) return {};
  return std::jthread([&session, id](const std::stop_token& stop) {
    ProgressMeter meter;
    const auto show = [&](const v1::Job& job) {
      session.terminal().Progress(meter.Line(job, absl::Now()));
      return absl::OkStatus();
    };
    // Progress is a courtesy: what is wrong with the job, its stream says.
    static_cast<void>(session.client().Watch(id, show, stop));
    session.terminal().ClearProgress();
  });
}

ExitCode SayInterrupted(const Session& session, const std::string& id,
                        const std::optional<absl::Status>& cancelled) {
  if (!cancelled) {
    session.terminal().Say(session.resumes() ? "interrupted; the same command goes on from here"
                                             : "interrupted");
  } else if (cancelled->ok()) {
    session.terminal().Say(absl::StrCat("interrupted: job ", id, " is cancelled"));
  } else {
    session.terminal().Say(absl::StrCat(
        "interrupted: job ", id, " may go on, it could not be cancelled: ", cancelled->message()));
  }
  return kInterrupted;
}

/// A job whose output nobody takes is not computed to its end.
ExitCode OutputFailed(const Session& session, const v1::Job& job, const FollowOptions& options,
                      const absl::Status& status) {
  constexpr absl::Duration kPatience = absl::Seconds(2);
  if (options.cancel_on_exit) static_cast<void>(session.client().Cancel(job.id(), kPatience));
  return session.Written(status);
}

}  // namespace

ExitCode Follow(const Session& session, const Analysis& analysis, const v1::Job& job,
                const FollowOptions& options) {
  ResultPrinter printer(session.format(), analysis, session.terminal());
  std::stop_source give_up;
  std::optional<CancelOnInterrupt> canceller;
  std::optional<std::stop_callback<std::function<void()>>> leaver;
  if (options.cancel_on_exit) {
    canceller.emplace(session.client(), job.id(), session.interrupt(), give_up);
  } else {
    leaver.emplace(session.interrupt(), [give_up]() mutable { give_up.request_stop(); });
  }

  absl::StatusOr<v1::Result> result;
  absl::Status printed;
  {
    const std::jthread progress = ShowProgress(session, job.id());
    const auto print = [&](const v1::Record& record) { return printed = printer.Print(record); };
    result = session.client().Stream(job.id(), options.after, print, give_up.get_token());
  }
  const auto cancelled = canceller ? canceller->Finish() : std::nullopt;
  if (session.interrupt().stop_requested()) return SayInterrupted(session, job.id(), cancelled);
  if (result.ok()) printed = printer.Print(job, *result);
  if (!printed.ok()) return OutputFailed(session, job, options, printed);
  return result.ok() ? kDone : session.Fail(result.status());
}

}  // namespace celt::cli
