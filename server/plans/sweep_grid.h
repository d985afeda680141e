#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "core/map/system.h"

namespace celt::plans {

/// The most nodes of a sweep.
inline constexpr std::int64_t kMaxNodes = 10'000'000;

/// The nodes of a resolved sweep: arithmetic on its axes, and the job that each node stands for.
class SweepGrid {
 public:
  /// Checks the axes, which name parameters of the system and have their ends and 2 nodes or more.
  /// INVALID_ARGUMENT names the axis.
  static absl::Status Check(const System& system, const v1::SweepSpec& spec);

  /// `spec` has a sweep whose axes are checked.
  explicit SweepGrid(const v1::JobSpec& spec);

  std::int64_t nodes() const { return columns_ * rows_; }
  /// Nodes along the first axis, and along the second.
  std::int64_t columns() const { return columns_; }
  std::int64_t rows() const { return rows_; }

  /// Of the parameters, in the order of the axes; the first varies fastest.
  std::vector<double> Values(std::int64_t node) const;

  /// The node's own job: the sweep's with the parameters set and the analysis in the sweep's place,
  /// which is resolved but for what depends on the parameters: resolve it again.
  v1::JobSpec NodeSpec(std::int64_t node) const;

 private:
  v1::JobSpec base_;
  std::vector<v1::Axis> axes_;
  std::int64_t columns_;
  std::int64_t rows_;
};

/// The analysis of a sweep, in a job's place for it; and back.
void PutAnalysis(const v1::SweepSpec& from, v1::JobSpec& to);
void PutAnalysis(const v1::JobSpec& from, v1::SweepSpec& to);

/// Moves a node's result, of whatever analysis, into its record. False when a sweep has no place
/// for it.
bool PutOutcome(const v1::Result& result, v1::SweepRecord& record);

}  // namespace celt::plans
