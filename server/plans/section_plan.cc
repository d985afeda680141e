#include "server/plans/section_plan.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "core/analysis/section.h"
#include "core/model/angle.h"
#include "server/jobs/status_macros.h"
#include "server/plans/accuracy.h"
#include "server/plans/chain_plan.h"
#include "server/plans/convert.h"
#include "server/plans/pack_points.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"
#include "server/plans/state.pb.h"

namespace celt::plans {
namespace {

constexpr std::int64_t kDefaultIterates = 1000;
constexpr std::int64_t kMostTransient = 1'000'000'000'000;

/// Iterates of a unit: for a second or less, and no more records than a transaction should have.
std::int64_t UnitIterates(const v1::JobSpec& spec) {
  const v1::Engine engine = spec.numerics().engine();
  return engine == v1::ENGINE_CVODE || engine == v1::ENGINE_ARKODE ? 500 : 4000;
}

std::int64_t UnitsOf(std::int64_t iterates, std::int64_t unit) {
  return (iterates + unit - 1) / unit;
}

/// Its numbers, an angle in [0, 2 pi).
std::vector<double> Coordinates(const v1::Point& point) {
  if (!point.has_l()) return {point.x().begin(), point.x().end()};
  return {WrapToTurn(point.l()), point.l_over_g(), point.h_over_g()};
}

void Widen(const v1::Point& point, SectionState& state) {
  const std::vector<double> x = Coordinates(point);
  if (state.lowest().empty()) {
    state.mutable_lowest()->Add(x.begin(), x.end());
    state.mutable_highest()->Add(x.begin(), x.end());
  }
  for (int i = 0; i < state.lowest_size(); ++i) {
    state.set_lowest(i, std::min(state.lowest(i), x[i]));
    state.set_highest(i, std::max(state.highest(i), x[i]));
  }
}

class SectionPlan final : public ChainPlan {
 public:
  SectionPlan(const v1::JobSpec& resolved, std::unique_ptr<Map> map, Point start,
              Direction direction)
      : spec_(resolved),
        frame_(resolved),
        section_(resolved.section()),
        unit_(UnitIterates(resolved)),
        map_(std::move(map)),
        start_(std::move(start)),
        direction_(direction) {}

  jobs::Work work() const override {
    return {.total = static_cast<double>(section_.transient() + section_.iterates()),
            .unit = "iterates"};
  }

 private:
  std::int64_t MostSteps() const override {
    return UnitsOf(section_.transient(), unit_) + UnitsOf(section_.iterates(), unit_);
  }
  absl::StatusOr<Stretch> Advance(std::string_view before,
                                  const jobs::StopRequested& stop) const override;
  absl::StatusOr<v1::Result> MakeResult(std::string_view known) const override;

  /// Adds a record, and takes it into account.
  void Add(const SectionRecord& record, SectionState& state, Stretch& stretch) const;
  absl::Status Go(SectionOrbit& orbit, SectionState& state, Stretch& stretch,
                  const jobs::StopRequested& stop) const;

  const v1::JobSpec spec_;
  const PointFrame frame_;
  const v1::SectionSpec section_;
  const std::int64_t unit_;
  const std::unique_ptr<Map> map_;
  const Point start_;
  const Direction direction_;
};

void SectionPlan::Add(const SectionRecord& record, SectionState& state, Stretch& stretch) const {
  v1::SectionRecord& out = *stretch.records.emplace_back().mutable_section();
  out.set_iterate(record.at.iterate);
  *out.mutable_point() = frame_.FromPoint(record.at.point);
  out.set_time(record.at.time);
  if (record.at.iterate != 0) out.set_return_time(record.return_time);
  const std::int64_t index = std::abs(record.at.iterate) - section_.transient();
  if (IsInSample(index, section_.iterates())) PackPoint(record.at.point, *state.mutable_sample());
  state.set_recorded(state.recorded() + record.return_time);
  Widen(out.point(), state);
}

/// The next iterates of the transient, or else of those that are recorded. An orbit that is lost
/// ends the stretch with an error.
absl::Status SectionPlan::Go(SectionOrbit& orbit, SectionState& state, Stretch& stretch,
                             const jobs::StopRequested& stop) const {
  const std::int64_t done = std::abs(orbit.iterate);
  const bool transient = done < section_.transient();
  const std::int64_t end =
      transient ? section_.transient() : section_.transient() + section_.iterates();
  if (done == 0 && !transient) Add({.at = orbit, .return_time = 0}, state, stretch);
  absl::Status status = AdvanceSection(*map_, orbit, std::min(unit_, end - done), direction_,
                                       [&](const SectionRecord& record) {
                                         if (!transient) Add(record, state, stretch);
                                         return !stop();
                                       });
  if (absl::IsCancelled(status)) return status;
  if (!status.ok()) {
    stretch.error = absl::Status(status.code(), absl::StrCat("after ", std::abs(orbit.iterate),
                                                             " iterates: ", status.message()));
  }
  stretch.work = static_cast<double>(std::abs(orbit.iterate) - done);
  stretch.ended = std::abs(orbit.iterate) == section_.transient() + section_.iterates();
  return absl::OkStatus();
}

absl::StatusOr<Stretch> SectionPlan::Advance(std::string_view before,
                                             const jobs::StopRequested& stop) const {
  CELT_ASSIGN_OR_RETURN(SectionState state, Parse<SectionState>(before));
  SectionOrbit orbit = {.point = start_, .iterate = state.iterate(), .time = state.time()};
  if (state.iterate() != 0) {
    if (state.point_size() != start_.size()) {
      return absl::DataLossError("the stored state of the orbit is damaged");
    }
    std::copy(state.point().begin(), state.point().end(), orbit.point.begin());
  }
  Stretch stretch;
  CELT_RETURN_IF_ERROR(Go(orbit, state, stretch, stop));
  state.mutable_point()->Assign(orbit.point.begin(), orbit.point.end());
  state.set_iterate(orbit.iterate);
  state.set_time(orbit.time);
  stretch.state = stretch.summary = Serialize(state);
  return stretch;
}

absl::StatusOr<v1::Result> SectionPlan::MakeResult(std::string_view known) const {
  CELT_ASSIGN_OR_RETURN(const SectionState state, Parse<SectionState>(known));
  Point last = start_;
  std::copy(state.point().begin(), state.point().end(), last.begin());
  v1::Result result;
  v1::SectionResult& section = *result.mutable_section();
  section.set_iterates(std::abs(state.iterate()));
  section.set_mean_return_time(state.recorded() / static_cast<double>(section_.iterates()));
  *section.mutable_last() = frame_.FromPoint(last);
  *section.mutable_lowest() = state.lowest();
  *section.mutable_highest() = state.highest();
  CELT_ASSIGN_OR_RETURN(const std::vector<Point> sample,
                        UnpackPoints(state.sample(), map_->dimension()));
  CELT_ASSIGN_OR_RETURN(*section.mutable_accuracy(), MeasureAccuracy(spec_, *map_, sample));
  return result;
}

}  // namespace

absl::Status ResolveSection(const System& system, v1::JobSpec& spec) {
  v1::SectionSpec& section = *spec.mutable_section();
  if (!section.has_iterates()) section.set_iterates(kDefaultIterates);
  if (!section.has_transient()) section.set_transient(0);
  CELT_RETURN_IF_ERROR(CheckRange("iterates", section.iterates(), 1, kMostSectionIterates));
  CELT_RETURN_IF_ERROR(CheckRange("transient", section.transient(), 0, kMostTransient));
  CELT_ASSIGN_OR_RETURN(const Direction direction, ToDirection(section.direction()));
  section.set_direction(FromDirection(direction));
  return ResolvePoint(system, spec, "start", *section.mutable_start());
}

absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeSectionPlan(const v1::JobSpec& resolved) {
  CELT_ASSIGN_OR_RETURN(std::unique_ptr<Map> map, MakeMap(resolved));
  CELT_ASSIGN_OR_RETURN(Point start, PointFrame(resolved).ToPoint(resolved.section().start()));
  CELT_ASSIGN_OR_RETURN(const Direction direction, ToDirection(resolved.section().direction()));
  return std::make_unique<SectionPlan>(resolved, std::move(map), std::move(start), direction);
}

}  // namespace celt::plans
