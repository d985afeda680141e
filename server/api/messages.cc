#include "server/api/messages.h"

#include <string>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"

namespace celt::api {
namespace {

absl::Status Damaged(const char* what, const std::string& id) {
  return absl::DataLossError(absl::StrCat("job ", id, ": the stored ", what, " is damaged"));
}

void SetTime(absl::Time time, google::protobuf::Timestamp& timestamp) {
  const std::int64_t seconds = absl::ToUnixSeconds(time);
  timestamp.set_seconds(seconds);
  timestamp.set_nanos(
      static_cast<std::int32_t>(absl::ToInt64Nanoseconds(time - absl::FromUnixSeconds(seconds))));
}

void FillState(const jobs::Job& job, v1::Job& message) {
  message.set_id(job.id);
  message.set_owner(job.owner);
  message.set_state(static_cast<v1::Job::State>(job.state));
  v1::Progress& progress = *message.mutable_progress();
  progress.set_done(job.work_done);
  progress.set_total(job.work_total);
  progress.set_unit(job.work_unit);
  message.set_last_sequence(job.last_sequence);
  if (job.state != jobs::JobState::kFailed) return;
  message.mutable_error()->set_code(static_cast<int>(job.error.code()));
  message.mutable_error()->set_message(std::string(job.error.message()));
}

void FillTimes(const jobs::Job& job, v1::Job& message) {
  SetTime(job.created, *message.mutable_create_time());
  if (job.started != absl::InfinitePast()) SetTime(job.started, *message.mutable_start_time());
  if (job.ended != absl::InfinitePast()) SetTime(job.ended, *message.mutable_end_time());
}

}  // namespace

absl::StatusOr<v1::Job> ToMessage(const jobs::Job& job) {
  v1::Job message;
  if (!message.mutable_spec()->ParseFromString(job.specification)) {
    return Damaged("specification", job.id);
  }
  FillState(job, message);
  FillTimes(job, message);
  return message;
}

v1::Estimate ToMessage(const jobs::Estimate& estimate) {
  v1::Estimate message;
  message.set_most_units(estimate.most_units);
  message.set_iterates(estimate.iterates);
  message.set_seconds(absl::ToDoubleSeconds(estimate.alone));
  message.set_queue_seconds(absl::ToDoubleSeconds(estimate.queue));
  return message;
}

absl::StatusOr<v1::Record> ToMessage(const jobs::StoredRecord& record) {
  v1::Record message;
  if (!message.ParseFromString(record.bytes)) {
    return absl::DataLossError(absl::StrCat("stored record ", record.sequence, " is damaged"));
  }
  message.set_sequence(record.sequence);
  return message;
}

absl::StatusOr<v1::Result> ResultOf(const jobs::Job& job) {
  v1::Result message;
  if (!message.ParseFromString(job.result)) return Damaged("result", job.id);
  return message;
}

absl::StatusOr<jobs::JobFilter> ToFilter(const v1::ListJobsRequest& request) {
  jobs::JobFilter filter;
  for (const int state : request.states()) {
    if (!v1::Job::State_IsValid(state) || state == v1::Job::STATE_UNSPECIFIED) {
      return absl::InvalidArgumentError(absl::StrCat("states: ", state, " is no state of a job"));
    }
    filter.states.push_back(static_cast<jobs::JobState>(state));
  }
  return filter;
}

}  // namespace celt::api
