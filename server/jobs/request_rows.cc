#include "server/jobs/request_rows.h"

#include "absl/strings/cord.h"
#include "absl/strings/str_cat.h"
#include "server/jobs/status_details.h"
#include "server/jobs/status_macros.h"

namespace celt::jobs {
namespace {

absl::Status UsedBefore(const Request& request, const Job& job) {
  absl::Status status = absl::AlreadyExistsError(
      absl::StrCat("request_id: ", request.id, " was used for another request, by job ", job.id));
  status.SetPayload(kExistingJobPayload, absl::Cord(job.id));
  return status;
}

}  // namespace

absl::StatusOr<std::optional<JobRow>> FindRequest(Database& database, const Request& request,
                                                  const Job& wanted) {
  std::optional<JobRow> found;
  if (request.id.empty()) return found;
  std::int64_t reuse = 0;
  CELT_RETURN_IF_ERROR(database.Query(
      "SELECT " CELT_JOB_COLUMNS
      ", reuse FROM jobs JOIN (SELECT job, reuse FROM requests WHERE owner = ? AND request_id = ?) "
      "ON job = serial",
      {std::string_view(request.owner), std::string_view(request.id)}, [&](const Row& row) {
        found = ToJobRow(row);
        reuse = row.Int(kJobColumns);
        return false;
      }));
  if (!found) return found;
  const bool same = found->job.specification == wanted.specification &&
                    reuse == static_cast<std::int64_t>(request.reuse);
  if (!same) return UsedBefore(request, found->job);
  return found;
}

absl::Status InsertRequest(Database& database, const Request& request, std::int64_t job) {
  if (request.id.empty()) return absl::OkStatus();
  return database.Run("INSERT INTO requests (owner, request_id, job, reuse) VALUES (?, ?, ?, ?)",
                      {std::string_view(request.owner), std::string_view(request.id), job,
                       static_cast<std::int64_t>(request.reuse)});
}

}  // namespace celt::jobs
