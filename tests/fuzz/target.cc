#include "tests/fuzz/target.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include "celt/v1/job.pb.h"
#include "server/jobs/page_token.h"
#include "server/jobs/sqlite_store.h"
#include "server/plans/factory.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"

namespace celt::fuzz {
namespace {

void Require(bool promise) {
  if (!promise) std::abort();
}

void TakeSpecification(std::string_view bytes) {
  v1::JobSpec spec;
  if (!spec.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return;
  const auto resolved = plans::ResolveSpec(spec);
  if (!resolved.ok()) return Require(!resolved.status().message().empty());
  const std::string once = plans::Serialize(*resolved);
  const auto again = plans::ResolveSpec(*resolved);
  Require(again.ok() && plans::Serialize(*again) == once);
  Require(plans::MakePlan(once).ok());
}

void TakePageToken(std::string_view text) {
  const auto token = jobs::DecodePageToken(text);
  if (!token.ok()) return;
  const auto again = jobs::DecodePageToken(jobs::Encode(*token));
  Require(again.ok() && again->created == token->created && again->states == token->states &&
          again->id == token->id);
}

constexpr std::int64_t kRecords = 5;

/// A store with one job of a few records.
std::unique_ptr<jobs::SqliteStore> MakeStore() {
  auto store = *jobs::SqliteStore::Open(":memory:");
  jobs::Job job;
  job.id = "job";
  Require(store->Create(job, "", jobs::Reuse::kNothing, absl::OkStatus()).ok());
  jobs::UnitCommit commit;
  commit.records.assign(kRecords, "record");
  Require(store->Commit(job.id, commit).ok());
  return store;
}

const jobs::SqliteStore& Store() {
  static const jobs::SqliteStore& store = *MakeStore().release();
  return store;
}

void TakePage(std::string_view token) {
  const auto page = Store().List({}, 1, token);
  Require(page.ok() || !page.status().message().empty());
}

/// Where a stream goes on: from any number on it gives what comes after, and nothing else.
void TakeResumePoint(std::string_view bytes) {
  std::int64_t after = 0;
  std::memcpy(&after, bytes.data(), std::min(bytes.size(), sizeof after));
  const auto records = Store().Records("job", after, 1 << 20);
  if (after < 0) return Require(absl::IsInvalidArgument(records.status()));
  Require(records.ok());
  const std::int64_t first = std::min(after, kRecords);
  Require(std::ssize(*records) == kRecords - first);
  Require(records->empty() || records->front().sequence == first + 1);
}

}  // namespace

void TakeApart(std::string_view input) {
  if (input.empty()) return;
  const std::string_view rest = input.substr(1);
  switch (input.front()) {
    case 't':
      TakePageToken(rest);
      return TakePage(rest);
    case 'r':
      return TakeResumePoint(rest);
    default:
      return TakeSpecification(rest);
  }
}

}  // namespace celt::fuzz
