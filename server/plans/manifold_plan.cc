#include "server/plans/manifold_plan.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/analysis/manifold.h"
#include "core/analysis/separatrix.h"
#include "server/jobs/status_macros.h"
#include "server/plans/accuracy.h"
#include "server/plans/chain_plan.h"
#include "server/plans/convert.h"
#include "server/plans/convert_cycle.h"
#include "server/plans/cycle_state.h"
#include "server/plans/manifold_spec.h"
#include "server/plans/manifold_state.h"
#include "server/plans/pack_points.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"
#include "server/plans/state.pb.h"

namespace celt::plans {
namespace {

/// No bound is known beforehand; a side has at most most_generations, each of many parts.
constexpr std::int64_t kManySteps = 1'000'000'000;
/// Sides this short go on for several parts in one unit.
constexpr std::size_t kFewPoints = 500;
constexpr int kPartsOfFew = 8;
/// Of each side, for the accuracy.
constexpr int kSample = 8;

const char* Name(ManifoldEnd end) {
  switch (end) {
    case ManifoldEnd::kLength:
      return "length";
    case ManifoldEnd::kMostPoints:
      return "most points";
    case ManifoldEnd::kMostGenerations:
      return "most generations";
    case ManifoldEnd::kLost:
      return "lost";
    case ManifoldEnd::kTorn:
      return "torn";
    case ManifoldEnd::kNotYet:
      break;
  }
  return "";
}

/// Arc length recorded, of both sides.
double Done(const v1::ManifoldResult& result) {
  double done = 0;
  for (const v1::ManifoldSide& side : result.sides()) done += side.length();
  return done;
}

/// A unit under way.
struct Unit {
  ManifoldState state;
  v1::ManifoldResult result;
  Stretch stretch;
  const jobs::StopRequested& stop;
};

class ManifoldPlan final : public ChainPlan {
 public:
  ManifoldPlan(const v1::JobSpec& resolved, std::unique_ptr<Map> map, Point near)
      : spec_(resolved),
        frame_(resolved),
        options_(ManifoldOptionsOf(resolved)),
        direction_(resolved.manifold().stable() ? Direction::kBackward : Direction::kForward),
        map_(std::move(map)),
        near_(std::move(near)) {}

  jobs::Work work() const override {
    return {.total = 2 * options_.length, .unit = "units of length"};
  }

 private:
  std::int64_t MostSteps() const override { return kManySteps; }
  absl::StatusOr<Stretch> Advance(std::string_view before,
                                  const jobs::StopRequested& stop) const override;
  absl::StatusOr<v1::Result> MakeResult(std::string_view known) const override;

  /// The next part of the work.
  absl::Status Go(Unit& unit) const;
  absl::Status FindSaddle(Unit& unit) const;
  absl::StatusOr<Saddle> SaddleOf(const ManifoldState& state) const;
  absl::Status FollowFate(const Saddle& saddle, v1::ManifoldSide& out, Unit& unit) const;
  absl::Status Trace(const Saddle& saddle, v1::ManifoldSide& out, Unit& unit) const;
  void Add(const ManifoldPoint& point, int side, Unit& unit) const;

  const v1::JobSpec spec_;
  const PointFrame frame_;
  const ManifoldOptions options_;
  const Direction direction_;
  const std::unique_ptr<Map> map_;
  const Point near_;
};

absl::Status ManifoldPlan::FindSaddle(Unit& unit) const {
  const int period = spec_.manifold().period();
  CELT_ASSIGN_OR_RETURN(const CycleReport cycle, FindCycle(*map_, near_, period));
  CELT_RETURN_IF_ERROR(CheckFound(cycle, period));
  *unit.state.mutable_cycle() = ToState(cycle);
  CELT_RETURN_IF_ERROR(SaddleOf(unit.state).status());
  *unit.result.mutable_saddle() = FromCycle(cycle, frame_);
  for (const int side : {1, -1}) unit.result.add_sides()->set_side(side);
  return absl::OkStatus();
}

/// That a cycle is no saddle is found in computing, and is no fault of the specification's form.
absl::StatusOr<Saddle> ManifoldPlan::SaddleOf(const ManifoldState& state) const {
  CELT_ASSIGN_OR_RETURN(const CycleReport cycle, FromState(state.cycle()));
  auto saddle = MakeSaddle(*map_, cycle.points, direction_);
  if (!absl::IsInvalidArgument(saddle.status())) return saddle;
  return absl::FailedPreconditionError(saddle.status().message());
}

absl::Status ManifoldPlan::FollowFate(const Saddle& saddle, v1::ManifoldSide& out,
                                      Unit& unit) const {
  SeparatrixOptions options;
  options.side = out.side();
  CELT_ASSIGN_OR_RETURN(
      const SeparatrixFate fate,
      FollowSeparatrix(*map_, saddle, options, [&unit](std::int64_t) { return !unit.stop(); }));
  *out.mutable_fate() = FromFate(fate, saddle.iterates, frame_);
  return absl::OkStatus();
}

void ManifoldPlan::Add(const ManifoldPoint& point, int side, Unit& unit) const {
  v1::ManifoldRecord& record = *unit.stretch.records.emplace_back().mutable_manifold();
  record.set_side(side);
  record.set_arc_length(point.arc_length);
  record.set_generation(point.generation);
  *record.mutable_point() = frame_.FromPoint(point.point);
  // Evenly over the length of both sides.
  auto& sample = *unit.state.mutable_summary()->mutable_sample();
  const double taken = static_cast<double>(sample.size()) / map_->dimension();
  const double done = (side > 0 ? 0 : 1) + std::min(point.arc_length / options_.length, 1.0);
  if (taken < done * kSample) PackPoint(point.point, sample);
}

/// Some parts of a side. Its records come in order of arc length.
absl::Status ManifoldPlan::Trace(const Saddle& saddle, v1::ManifoldSide& out, Unit& unit) const {
  ManifoldSide side;
  if (!unit.state.side().empty()) {
    CELT_ASSIGN_OR_RETURN(side, DecodeSide(unit.state.side(), map_->dimension()));
  } else {
    CELT_ASSIGN_OR_RETURN(side, StartManifold(*map_, saddle, out.side(), options_));
  }
  for (int part = 0; part < kPartsOfFew && !side.done; ++part) {
    CELT_RETURN_IF_ERROR(
        AdvanceManifold(*map_, saddle, options_, side, [&](const ManifoldPoint& point) {
          Add(point, out.side(), unit);
          return !unit.stop();
        }));
    if (unit.stop()) return absl::CancelledError("stopped before the manifold was done");
    if (side.points.size() > kFewPoints) break;
  }
  out.set_points(side.written);
  out.set_length(side.arc_length);
  unit.state.set_side(EncodeSide(side));
  if (!side.done) return absl::OkStatus();
  out.set_end(Name(side.end));
  if (!side.message.empty()) out.set_message(side.message);
  unit.state.clear_side();
  return absl::OkStatus();
}

absl::Status ManifoldPlan::Go(Unit& unit) const {
  if (!unit.state.has_cycle()) return FindSaddle(unit);
  CELT_ASSIGN_OR_RETURN(const Saddle saddle, SaddleOf(unit.state));
  for (v1::ManifoldSide& side : *unit.result.mutable_sides()) {
    if (!side.has_fate()) return FollowFate(saddle, side, unit);
  }
  for (v1::ManifoldSide& side : *unit.result.mutable_sides()) {
    if (!side.has_end()) return Trace(saddle, side, unit);
  }
  return absl::InternalError("the manifold is done and goes on");
}

absl::StatusOr<Stretch> ManifoldPlan::Advance(std::string_view before,
                                              const jobs::StopRequested& stop) const {
  Unit unit = {.state = {}, .result = {}, .stretch = {}, .stop = stop};
  CELT_ASSIGN_OR_RETURN(unit.state, Parse<ManifoldState>(before));
  CELT_ASSIGN_OR_RETURN(unit.result, Parse<v1::ManifoldResult>(unit.state.summary().result()));
  const double done = Done(unit.result);
  CELT_RETURN_IF_ERROR(Go(unit));
  unit.state.mutable_summary()->set_result(Serialize(unit.result));
  unit.stretch.work = Done(unit.result) - done;
  unit.stretch.ended = unit.result.sides(1).has_end();
  unit.stretch.summary = Serialize(unit.state.summary());
  unit.stretch.state = Serialize(unit.state);
  return std::move(unit.stretch);
}

absl::StatusOr<v1::Result> ManifoldPlan::MakeResult(std::string_view known) const {
  CELT_ASSIGN_OR_RETURN(const ManifoldSummary summary, Parse<ManifoldSummary>(known));
  v1::Result result;
  CELT_ASSIGN_OR_RETURN(*result.mutable_manifold(), Parse<v1::ManifoldResult>(summary.result()));
  CELT_ASSIGN_OR_RETURN(const std::vector<Point> sample,
                        UnpackPoints(summary.sample(), map_->dimension()));
  CELT_ASSIGN_OR_RETURN(*result.mutable_manifold()->mutable_accuracy(),
                        MeasureAccuracy(spec_, *map_, sample));
  return result;
}

}  // namespace

absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeManifoldPlan(const v1::JobSpec& resolved) {
  CELT_ASSIGN_OR_RETURN(std::unique_ptr<Map> map, MakeMap(resolved));
  CELT_ASSIGN_OR_RETURN(Point near, PointFrame(resolved).ToPoint(resolved.manifold().near()));
  return std::make_unique<ManifoldPlan>(resolved, std::move(map), std::move(near));
}

}  // namespace celt::plans
