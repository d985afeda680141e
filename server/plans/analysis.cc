#include "server/plans/analysis.h"

#include "server/plans/continuation_plan.h"
#include "server/plans/continuation_spec.h"
#include "server/plans/fixed_point_plan.h"
#include "server/plans/fixed_point_spec.h"
#include "server/plans/hyperbolicity_plan.h"
#include "server/plans/hyperbolicity_spec.h"
#include "server/plans/lyapunov_plan.h"
#include "server/plans/lyapunov_spec.h"
#include "server/plans/manifold_plan.h"
#include "server/plans/manifold_spec.h"
#include "server/plans/orbit_plan.h"
#include "server/plans/orbit_spec.h"
#include "server/plans/reproduce_plan.h"
#include "server/plans/section_plan.h"
#include "server/plans/separatrix_plan.h"
#include "server/plans/separatrix_spec.h"
#include "server/plans/sweep_grid.h"
#include "server/plans/sweep_plan.h"

namespace celt::plans {
namespace {

/// For what is located rather than averaged: cycles and their multipliers to 1e-10.
constexpr double kFineTolerance = 1e-13;

double ToleranceOfNodes(const v1::JobSpec& spec) {
  v1::JobSpec node;
  PutAnalysis(spec.sweep(), node);
  const auto analysis = FindAnalysis(node);
  return analysis.ok() ? analysis->tolerance : Numerics().tolerance;
}

}  // namespace

absl::StatusOr<Analysis> FindAnalysis(const v1::JobSpec& spec) {
  switch (spec.analysis_case()) {
    case v1::JobSpec::kLyapunov:
      return Analysis{ResolveLyapunov, MakeLyapunovPlan};
    case v1::JobSpec::kHyperbolicity:
      return Analysis{ResolveHyperbolicity, MakeHyperbolicityPlan};
    case v1::JobSpec::kManifold:
      return Analysis{ResolveManifold, MakeManifoldPlan};
    case v1::JobSpec::kOrbit:
      return Analysis{ResolveOrbit, MakeOrbitPlan};
    case v1::JobSpec::kSection:
      return Analysis{ResolveSection, MakeSectionPlan};
    case v1::JobSpec::kReproduce:
      return Analysis{ResolveReproduce, MakeReproducePlan};
    case v1::JobSpec::kSweep:
      return Analysis{ResolveSweep, MakeSweepPlan, ToleranceOfNodes(spec)};
    case v1::JobSpec::kFixedPoint:
      return Analysis{ResolveFixedPoint, MakeFixedPointPlan, kFineTolerance};
    case v1::JobSpec::kContinuation:
      return Analysis{ResolveContinuation, MakeContinuationPlan, kFineTolerance};
    case v1::JobSpec::kSeparatrix:
      return Analysis{ResolveSeparatrix, MakeSeparatrixPlan, kFineTolerance};
    default:
      return absl::InvalidArgumentError("analysis: missing, or not known here");
  }
}

}  // namespace celt::plans
