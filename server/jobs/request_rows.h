#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/jobs/database.h"
#include "server/jobs/job_rows.h"
#include "server/jobs/store.h"

namespace celt::jobs {

/// Requests that clients have named, as rows of the table `requests`: the one place that knows its
/// columns. A request is remembered as long as its job.

struct Request {
  std::string owner;
  std::string id;  ///< empty: the request has no name, and nothing is remembered
  Reuse reuse = Reuse::kNothing;
};

/// The job that the request was answered with before. ALREADY_EXISTS when what was asked for was
/// not `wanted`; its payload kExistingJobPayload is the id of that job.
absl::StatusOr<std::optional<JobRow>> FindRequest(Database& database, const Request& request,
                                                  const Job& wanted);
absl::Status InsertRequest(Database& database, const Request& request, std::int64_t job);

}  // namespace celt::jobs
