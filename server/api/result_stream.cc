#include "server/api/result_stream.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "server/api/messages.h"

namespace celt::api {
namespace {

/// Read from the store at a time: what a client that does not read costs.
constexpr std::size_t kChunkBytes = 64 * 1024;

}  // namespace

ResultStream::Step ResultStream::Look() {
  if (!chunk_.empty()) return WriteRecord();
  // First the job, then the records: when it has ended by now, no records come after those that are
  // read now.
  const absl::StatusOr<jobs::Job> job = store_.Get(id_);
  if (!job.ok()) return Step::Finish(job.status());
  auto records = store_.Records(id_, after_, kChunkBytes);
  if (!records.ok()) return Step::Finish(records.status());
  chunk_.assign(std::make_move_iterator(records->begin()), std::make_move_iterator(records->end()));
  return chunk_.empty() ? AfterTheRecords(*job) : WriteRecord();
}

ResultStream::Step ResultStream::WriteRecord() {
  absl::StatusOr<v1::Record> record = ToMessage(chunk_.front());
  if (!record.ok()) return Step::Finish(record.status());
  after_ = chunk_.front().sequence;
  chunk_.pop_front();
  v1::StreamResultsResponse response;
  *response.mutable_record() = *std::move(record);
  return Step::Write(std::move(response));
}

ResultStream::Step ResultStream::AfterTheRecords(const jobs::Job& job) {
  switch (job.state) {
    case jobs::JobState::kQueued:
    case jobs::JobState::kRunning:
      return Step::Wait();
    case jobs::JobState::kFailed:
      return Step::Finish(absl::FailedPreconditionError(
          absl::StrCat("job ", id_, " failed: ", job.error.message())));
    case jobs::JobState::kCancelled:
      return Step::Finish(absl::AbortedError(absl::StrCat("job ", id_, " was cancelled")));
    case jobs::JobState::kSucceeded:
      break;
  }
  if (result_written_) return Step::Finish(absl::OkStatus());
  absl::StatusOr<v1::Result> result = ResultOf(job);
  if (!result.ok()) return Step::Finish(result.status());
  result_written_ = true;
  v1::StreamResultsResponse response;
  *response.mutable_result() = *std::move(result);
  return Step::Write(std::move(response));
}

}  // namespace celt::api
