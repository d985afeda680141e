#pragma once

#include <string>

#include "celt/v1/job.pb.h"
#include "core/analysis/bifurcation.h"
#include "core/analysis/continuation.h"

namespace celt::plans {

/// Pieces of branches for the contract. A node's points are shown in the job's frame as it is at
/// the node's own value of the parameter.
class BranchConverter {
 public:
  /// `spec`: resolved, with a continuation.
  explicit BranchConverter(v1::JobSpec spec) : spec_(std::move(spec)) {}

  v1::Record PointRecord(int branch, const BranchPoint& point) const;
  v1::Record BifurcationRecord(int branch, const Bifurcation& bifurcation) const;

 private:
  v1::Cycle FromCycleAt(double value, const CycleReport& cycle) const;

  v1::JobSpec spec_;
};

}  // namespace celt::plans
