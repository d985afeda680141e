#include "server/plans/sweep_node.h"

#include <algorithm>
#include <memory>
#include <string>

#include "core/analysis/section.h"
#include "core/map/system.h"
#include "server/jobs/status_macros.h"
#include "server/plans/analysis.h"
#include "server/plans/convert.h"
#include "server/plans/run_plan.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"
#include "server/plans/sweep_grid.h"

namespace celt::plans {
namespace {

/// The orbit that an analysis follows, in its own words.
struct OrbitOf {
  v1::Point* start = nullptr;
  std::int64_t iterates = 0;
};

OrbitOf FindOrbit(v1::JobSpec& node) {
  switch (node.analysis_case()) {
    case v1::JobSpec::kLyapunov: {
      v1::LyapunovSpec& spec = *node.mutable_lyapunov();
      const std::int64_t orbits = std::max(spec.orbits(), 1);
      return {spec.mutable_start(), spec.transient() + spec.iterates() / orbits};
    }
    case v1::JobSpec::kSection: {
      v1::SectionSpec& spec = *node.mutable_section();
      return {spec.mutable_start(), spec.transient() + spec.iterates()};
    }
    case v1::JobSpec::kHyperbolicity: {
      v1::HyperbolicitySpec& spec = *node.mutable_hyperbolicity();
      return {spec.mutable_start(), spec.transient() + spec.scout() + spec.iterates()};
    }
    default:
      return {};
  }
}

absl::StatusOr<v1::Result> ResultOf(v1::JobSpec& node, const jobs::StopRequested& stop) {
  CELT_RETURN_IF_ERROR(ResolveNode(node));
  CELT_ASSIGN_OR_RETURN(const Analysis analysis, FindAnalysis(node));
  CELT_ASSIGN_OR_RETURN(const std::unique_ptr<jobs::Plan> plan, analysis.make_plan(node));
  CELT_ASSIGN_OR_RETURN(const std::string result, RunPlan(*plan, stop));
  return Parse<v1::Result>(result);
}

/// Pairs, points and pictures are for a job of its own.
void DropPictures(v1::Result& result) {
  if (result.has_hyperbolicity()) result.mutable_hyperbolicity()->clear_lmp_graph();
  if (result.has_continuation()) result.mutable_continuation()->clear_branch();
}

}  // namespace

absl::Status ResolveNode(v1::JobSpec& node) {
  CELT_ASSIGN_OR_RETURN(const System* system, FindSystem(node.system().name()));
  CELT_ASSIGN_OR_RETURN(const Analysis analysis, FindAnalysis(node));
  return analysis.resolve(*system, node);
}

double NodeWork(v1::JobSpec node) {
  if (!ResolveNode(node).ok()) return 0;
  const auto analysis = FindAnalysis(node);
  if (!analysis.ok()) return 0;
  const auto plan = analysis->make_plan(node);
  return plan.ok() ? (*plan)->work().total : 0;
}

absl::Status RunNode(v1::JobSpec node, const jobs::StopRequested& stop, v1::SweepRecord& record) {
  absl::StatusOr<v1::Result> result = ResultOf(node, stop);
  if (absl::IsCancelled(result.status())) return result.status();
  if (result.ok()) {
    DropPictures(*result);
    if (PutOutcome(*result, record)) return absl::OkStatus();
    result = absl::UnimplementedError("this analysis has no place in a sweep");
  }
  record.mutable_error()->set_code(result.status().raw_code());
  record.mutable_error()->set_message(std::string(result.status().message()));
  return absl::OkStatus();
}

bool FollowsOrbit(const v1::JobSpec& node) {
  v1::JobSpec copy = node;
  return FindOrbit(copy).start != nullptr;
}

void SetStart(const Point& start, v1::JobSpec& node) {
  const PointFrame frame(node);
  *FindOrbit(node).start = frame.FromPoint(start);
}

absl::StatusOr<Point> CarryOn(const v1::JobSpec& node, const jobs::StopRequested& stop) {
  v1::JobSpec copy = node;
  const OrbitOf orbit = FindOrbit(copy);
  CELT_ASSIGN_OR_RETURN(const Point start, PointFrame(node).ToPoint(*orbit.start));
  CELT_ASSIGN_OR_RETURN(const std::unique_ptr<Map> map, MakeMap(node));
  SectionOrbit at;
  at.point = start;
  CELT_RETURN_IF_ERROR(AdvanceSection(*map, at, orbit.iterates, Direction::kForward,
                                      [&](const SectionRecord&) { return !stop(); }));
  return at.point;
}

}  // namespace celt::plans
