#include "server/plans/hyperbolicity_plan.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "core/analysis/hyperbolicity.h"
#include "server/jobs/status_macros.h"
#include "server/plans/accuracy.h"
#include "server/plans/chain_plan.h"
#include "server/plans/convert.h"
#include "server/plans/hyperbolicity_answer.h"
#include "server/plans/hyperbolicity_spec.h"
#include "server/plans/hyperbolicity_state.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

/// Iterates with derivatives in about a second: some 2 ms each by SUNDIALS, 0.1 ms by the fast
/// engine, less by a formula.
std::int64_t UnitIterates(const v1::JobSpec& spec) {
  switch (spec.numerics().engine()) {
    case v1::ENGINE_FAST:
      return 8000;
    case v1::ENGINE_UNSPECIFIED:
      return 40'000;
    default:
      return 500;
  }
}

class HyperbolicityPlan final : public ChainPlan {
 public:
  HyperbolicityPlan(const v1::JobSpec& resolved, std::unique_ptr<Map> map, FramedOrbit start)
      : spec_(resolved),
        frame_(resolved),
        hyperbolicity_(resolved.hyperbolicity()),
        options_(HyperbolicityOptionsOf(resolved.hyperbolicity())),
        unit_(UnitIterates(resolved)),
        map_(std::move(map)),
        start_(std::move(start)) {}

  jobs::Work work() const override {
    return {.total = static_cast<double>(End()), .unit = "iterates"};
  }

 private:
  using Work = HyperbolicityWork;

  std::int64_t ScoutFrom() const { return hyperbolicity_.transient(); }
  std::int64_t MainFrom() const { return ScoutFrom() + hyperbolicity_.scout(); }
  std::int64_t End() const { return MainFrom() + hyperbolicity_.iterates(); }
  std::int64_t MostSteps() const override { return End() / unit_ + 3; }
  absl::StatusOr<Stretch> Advance(std::string_view before,
                                  const jobs::StopRequested& stop) const override;
  absl::StatusOr<v1::Result> MakeResult(std::string_view known) const override;

  absl::Status Go(Work& work, const jobs::StopRequested& stop) const;
  absl::Status Measure(Work& work, std::int64_t iterates, LyapunovTick tick) const;
  void AddRecord(const Work& work, Stretch& stretch) const;

  const v1::JobSpec spec_;
  const PointFrame frame_;
  const v1::HyperbolicitySpec hyperbolicity_;
  const HyperbolicityOptions options_;
  const std::int64_t unit_;
  const std::unique_ptr<Map> map_;
  const FramedOrbit start_;
};

/// Splits and sums up, stretch by stretch. What was done before a failure stays done.
absl::Status HyperbolicityPlan::Measure(Work& work, std::int64_t iterates,
                                        LyapunovTick tick) const {
  constexpr std::int64_t kStretch = 2000;
  const Whitening whitening = WhiteningOf(work.covariance);
  for (std::int64_t done = 0; done < iterates;) {
    const std::int64_t count = std::min(kStretch, iterates - done);
    CELT_ASSIGN_OR_RETURN(const SplittingStretch stretch,
                          AdvanceSplitting(*map_, work.splitting, count, options_.settle, tick));
    AddStretch(*map_, whitening, options_, stretch, work.sums);
    for (const SplittingSample& sample : stretch.samples) {
      if (!IsInSample(sample.iterate, hyperbolicity_.iterates())) continue;
      work.sample.push_back(sample.point);
    }
    done += count;
    work.done += count;
  }
  return absl::OkStatus();
}

absl::Status HyperbolicityPlan::Go(Work& work, const jobs::StopRequested& stop) const {
  const auto tick = [&stop](std::int64_t) { return !stop(); };
  FramedOrbit& orbit = work.splitting.orbit;
  if (work.done >= MainFrom()) return Measure(work, std::min(unit_, End() - work.done), tick);
  const bool transient = work.done < ScoutFrom();
  const std::int64_t iterates = std::min(unit_, (transient ? ScoutFrom() : MainFrom()) - work.done);
  if (transient) {
    CELT_RETURN_IF_ERROR(AdvanceFrames(*map_, {&orbit, 1}, iterates, tick).status());
  } else {
    CELT_RETURN_IF_ERROR(AdvanceCovariance(*map_, orbit, iterates, tick, work.covariance));
  }
  work.done += iterates;
  return absl::OkStatus();
}

void HyperbolicityPlan::AddRecord(const Work& work, Stretch& stretch) const {
  if (work.sums.samples == 0) return;
  v1::HyperbolicityRecord& record = *stretch.records.emplace_back().mutable_hyperbolicity();
  record.set_iterates(work.splitting.iterates);
  record.set_minimum_angle(work.sums.closest.angle);
  for (const Estimate& exponent : Summarize(work.sums.batches).per_iterate) {
    record.add_exponents_per_iterate(exponent.value);
  }
}

absl::StatusOr<Stretch> HyperbolicityPlan::Advance(std::string_view before,
                                                   const jobs::StopRequested& stop) const {
  Work work;
  work.splitting.orbit = start_;
  if (!before.empty()) {
    CELT_ASSIGN_OR_RETURN(work, DecodeHyperbolicity(before, map_->dimension()));
  }
  Stretch stretch;
  const std::int64_t done = work.done;
  const absl::Status status = Go(work, stop);
  if (absl::IsCancelled(status)) return absl::CancelledError(status.message());
  if (!status.ok()) {
    stretch.error = absl::Status(
        status.code(), absl::StrCat("after ", work.done, " iterates or more: ", status.message()));
  }
  stretch.work = static_cast<double>(work.done - done);
  if (stretch.work > 0) AddRecord(work, stretch);
  stretch.ended = work.done == End();
  stretch.state = EncodeHyperbolicity(work);
  if (stretch.ended) stretch.summary = stretch.state;
  return stretch;
}

absl::StatusOr<v1::Result> HyperbolicityPlan::MakeResult(std::string_view known) const {
  CELT_ASSIGN_OR_RETURN(const Work work, DecodeHyperbolicity(known, map_->dimension()));
  CELT_ASSIGN_OR_RETURN(const HyperbolicityReport report, JudgeHyperbolicity(work.sums, options_));
  v1::Result result;
  v1::HyperbolicityResult& hyperbolicity = *result.mutable_hyperbolicity();
  hyperbolicity = ToResult(report, frame_);
  CELT_ASSIGN_OR_RETURN(*hyperbolicity.mutable_accuracy(),
                        MeasureAccuracy(spec_, *map_, work.sample));
  return result;
}

}  // namespace

absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeHyperbolicityPlan(const v1::JobSpec& resolved) {
  const v1::HyperbolicitySpec& hyperbolicity = resolved.hyperbolicity();
  CELT_ASSIGN_OR_RETURN(std::unique_ptr<Map> map, MakeMap(resolved));
  CELT_ASSIGN_OR_RETURN(const Point start, PointFrame(resolved).ToPoint(hyperbolicity.start()));
  // One orbit starts at the start itself: only its frame is drawn.
  std::vector<FramedOrbit> orbits =
      DrawStarts(start, Point::Zero(start.size()), 1, hyperbolicity.seed());
  return std::make_unique<HyperbolicityPlan>(resolved, std::move(map), std::move(orbits.front()));
}

}  // namespace celt::plans
