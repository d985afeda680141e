#pragma once

#include "absl/status/statusor.h"
#include "celt/v1/celt.pb.h"
#include "server/jobs/forecast.h"
#include "server/jobs/job.h"
#include "server/jobs/store.h"

namespace celt::api {

/// From what the store keeps to the public contract. DATA_LOSS: the stored bytes are not what was
/// written.

absl::StatusOr<v1::Job> ToMessage(const jobs::Job& job);
v1::Estimate ToMessage(const jobs::Estimate& estimate);
absl::StatusOr<v1::Record> ToMessage(const jobs::StoredRecord& record);
absl::StatusOr<v1::Result> ResultOf(const jobs::Job& job);

/// INVALID_ARGUMENT: a state that no job is in.
absl::StatusOr<jobs::JobFilter> ToFilter(const v1::ListJobsRequest& request);

}  // namespace celt::api
