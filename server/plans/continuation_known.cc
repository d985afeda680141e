#include "server/plans/continuation_known.h"

#include <algorithm>
#include <cstdint>

#include "server/jobs/status_macros.h"
#include "server/plans/serialize.h"
#include "server/plans/state.pb.h"

namespace celt::plans {
namespace {

constexpr int kMostPoints = 2000;
constexpr std::size_t kMostBytes = 2U << 20U;

bool IsTooLong(const v1::ContinuationResult& result) {
  return result.branch_size() > kMostPoints ||
         (result.branch_size() > 2 && result.ByteSizeLong() > kMostBytes);
}

void KeepEverySecond(v1::ContinuationResult& result) {
  const int kept = (result.branch_size() + 1) / 2;
  for (int i = 1; i < kept; ++i) result.mutable_branch()->SwapElements(i, 2 * i);
  result.mutable_branch()->DeleteSubrange(kept, result.branch_size() - kept);
}

}  // namespace

absl::StatusOr<std::string> FoldContinuation(std::string_view bytes,
                                             const v1::ContinuationResult& found) {
  CELT_ASSIGN_OR_RETURN(ContinuationKnown known, Parse<ContinuationKnown>(bytes));
  CELT_ASSIGN_OR_RETURN(v1::ContinuationResult result,
                        Parse<v1::ContinuationResult>(known.result()));
  std::int64_t stride = std::max<std::int64_t>(1, known.stride());
  for (const v1::BranchPoint& point : found.branch()) {
    if (known.points() % stride == 0) *result.add_branch() = point;
    known.set_points(known.points() + 1);
  }
  for (; IsTooLong(result); stride *= 2) KeepEverySecond(result);
  for (const v1::Bifurcation& bifurcation : found.bifurcations()) {
    if (result.ByteSizeLong() < kMostBytes) *result.add_bifurcations() = bifurcation;
  }
  result.mutable_branches()->MergeFrom(found.branches());
  if (found.has_accuracy()) *result.mutable_accuracy() = found.accuracy();
  known.set_stride(stride);
  known.set_result(Serialize(result));
  return Serialize(known);
}

absl::StatusOr<v1::ContinuationResult> KnownContinuation(std::string_view bytes) {
  CELT_ASSIGN_OR_RETURN(const ContinuationKnown known, Parse<ContinuationKnown>(bytes));
  return Parse<v1::ContinuationResult>(known.result());
}

}  // namespace celt::plans
