#include "server/api/watch_stream.h"

#include <utility>

#include "server/api/messages.h"

namespace celt::api {
namespace {

constexpr absl::Duration kBetweenProgress = absl::Milliseconds(100);

bool SameProgress(const jobs::Job& a, const jobs::Job& b) {
  return a.work_done == b.work_done && a.last_sequence == b.last_sequence;
}

}  // namespace

WatchStream::Step WatchStream::Look() {
  if (told_ && HasEnded(told_->state)) return Step::Finish(absl::OkStatus());
  const absl::StatusOr<jobs::Job> job = store_.Get(id_);
  if (!job.ok()) return Step::Finish(job.status());
  if (!told_ || told_->state != job->state) return Tell(*job);
  if (SameProgress(*told_, *job)) return Step::Wait();
  const absl::Duration early = told_at_ + kBetweenProgress - absl::Now();
  return early > absl::ZeroDuration() ? Step::Wait(early) : Tell(*job);
}

WatchStream::Step WatchStream::Tell(const jobs::Job& job) {
  absl::StatusOr<v1::Job> message = ToMessage(job);
  if (!message.ok()) return Step::Finish(message.status());
  told_ = job;
  told_at_ = absl::Now();
  return Step::Write(*std::move(message));
}

}  // namespace celt::api
