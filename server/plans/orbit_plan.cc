#include "server/plans/orbit_plan.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/analysis/orbit.h"
#include "core/analysis/reversals.h"
#include "core/integrate/rolling_problem.h"
#include "server/jobs/status_macros.h"
#include "server/plans/chain_plan.h"
#include "server/plans/convert.h"
#include "server/plans/orbit_spec.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"
#include "server/plans/state.pb.h"

namespace celt::plans {
namespace {

/// A unit is so much time of the orbit, which takes about a second, or so many records.
constexpr double kUnitTime = 500;
constexpr std::int64_t kMostUnitRecords = 2000;

std::int64_t UnitRecords(double step) {
  const double records = std::clamp(kUnitTime / step, 1.0, static_cast<double>(kMostUnitRecords));
  return static_cast<std::int64_t>(records);
}

template <typename Vector>
void Set(const Vector& vector, google::protobuf::RepeatedField<double>& out) {
  out.Assign(vector.begin(), vector.end());
}

v1::OrbitRecord ToRecord(const OrbitRecord& record, const PointFrame& frame) {
  v1::OrbitRecord out;
  out.set_time(record.time);
  Set(record.state.head<3>(), *out.mutable_momentum());
  Set(record.state.tail<3>(), *out.mutable_gamma());
  Set(record.angular_velocity, *out.mutable_angular_velocity());
  Set(record.contact_on_body, *out.mutable_contact_on_body());
  Set(record.contact_on_plane, *out.mutable_contact_on_plane());
  out.set_heading(record.heading);
  out.set_spin_rate(record.spin_rate);
  out.set_turns(record.turns);
  const Andoyer& andoyer = record.andoyer;
  if (andoyer.G > 0) {
    *out.mutable_andoyer() =
        frame.FromPoint(Eigen::Vector3d(andoyer.l, andoyer.L / andoyer.G, andoyer.H / andoyer.G));
    out.set_g(frame.FromG(andoyer.g));
  }
  out.set_momentum_length(andoyer.G);
  out.set_energy_drift(record.energy_drift);
  out.set_gamma_drift(record.gamma_drift);
  return out;
}

/// What is known of an orbit's records so far.
struct Account {
  Reversals reversals;
  double energy_drift = 0;
  double energy_scale = 0;
  double gamma_drift = 0;

  void Take(const OrbitRecord& record) {
    reversals.Take(record.turns);
    energy_drift = std::max(energy_drift, std::abs(record.energy_drift));
    energy_scale = std::max(energy_scale, record.andoyer.G * record.angular_velocity.norm());
    gamma_drift = std::max(gamma_drift, std::abs(record.gamma_drift));
  }
};

std::string Encode(const StoneOrbit& orbit, const Account& account) {
  FlowOrbitState state;
  Set(Pack(orbit.state), *state.mutable_rolling());
  state.set_record(orbit.record);
  state.set_start_energy(orbit.start_energy);
  state.set_ended(orbit.ended);
  state.set_sense(account.reversals.sense);
  state.set_lowest_turns(account.reversals.lowest);
  state.set_highest_turns(account.reversals.highest);
  state.set_reversals(account.reversals.count);
  state.set_energy_drift(account.energy_drift);
  state.set_energy_scale(account.energy_scale);
  state.set_gamma_drift(account.gamma_drift);
  return Serialize(state);
}

absl::Status Decode(std::string_view bytes, StoneOrbit& orbit, Account& account) {
  CELT_ASSIGN_OR_RETURN(const FlowOrbitState state, Parse<FlowOrbitState>(bytes));
  if (state.rolling_size() != kRollingSize) {
    return absl::DataLossError("the stored state of the orbit is damaged");
  }
  orbit = {.state = UnpackRolling({state.rolling().data(), kRollingSize}),
           .record = state.record(),
           .start_energy = state.start_energy(),
           .ended = state.ended()};
  account = {.reversals = {.sense = state.sense(),
                           .lowest = state.lowest_turns(),
                           .highest = state.highest_turns(),
                           .count = state.reversals()},
             .energy_drift = state.energy_drift(),
             .energy_scale = state.energy_scale(),
             .gamma_drift = state.gamma_drift()};
  return absl::OkStatus();
}

class OrbitPlan final : public ChainPlan {
 public:
  OrbitPlan(const v1::JobSpec& resolved, StoneOrbit start, OrbitOptions options, Numerics numerics,
            std::int64_t records)
      : frame_(resolved),
        stone_(StoneOf(resolved)),
        start_(std::move(start)),
        options_(options),
        numerics_(numerics),
        unit_(UnitRecords(options.step)),
        records_(records) {}

  jobs::Work work() const override {
    return {.total = static_cast<double>(records_), .unit = "records"};
  }

 private:
  std::int64_t MostSteps() const override { return (records_ + unit_ - 1) / unit_; }
  absl::StatusOr<Stretch> Advance(std::string_view before,
                                  const jobs::StopRequested& stop) const override;
  absl::StatusOr<v1::Result> MakeResult(std::string_view known) const override;

  const PointFrame frame_;
  const CelticStone stone_;
  const StoneOrbit start_;
  const OrbitOptions options_;
  const Numerics numerics_;
  const std::int64_t unit_;
  const std::int64_t records_;  // after the start
};

absl::StatusOr<Stretch> OrbitPlan::Advance(std::string_view before,
                                           const jobs::StopRequested& stop) const {
  Stretch stretch;
  StoneOrbit orbit = start_;
  Account account;
  const auto add = [&](const OrbitRecord& record) {
    *stretch.records.emplace_back().mutable_orbit() = ToRecord(record, frame_);
    account.Take(record);
    return !stop();
  };
  if (before.empty()) {
    add(RecordOf(stone_, orbit, options_));
  } else {
    CELT_RETURN_IF_ERROR(Decode(before, orbit, account));
  }
  const std::int64_t from = orbit.record;
  stretch.error = AdvanceOrbit(stone_, orbit, options_, numerics_, unit_, add);
  if (absl::IsCancelled(stretch.error)) return stretch.error;
  stretch.work = static_cast<double>(orbit.record - from);
  stretch.ended = orbit.ended;
  stretch.state = stretch.summary = Encode(orbit, account);
  return stretch;
}

absl::StatusOr<v1::Result> OrbitPlan::MakeResult(std::string_view known) const {
  StoneOrbit orbit;
  Account account;
  CELT_RETURN_IF_ERROR(Decode(known, orbit, account));
  const OrbitRecord last = RecordOf(stone_, orbit, options_);
  v1::Result result;
  v1::OrbitResult& out = *result.mutable_orbit();
  out.set_records(orbit.record + 1);
  out.set_time(last.time);
  out.set_energy(orbit.start_energy);
  out.set_reversals(account.reversals.count);
  out.set_turns(last.turns);
  // A stone at rest has no scale, and no drift.
  const double scale = account.energy_scale > 0 ? account.energy_scale : 1;
  out.set_energy_drift(account.energy_drift / scale);
  out.set_gamma_drift(account.gamma_drift);
  return result;
}

}  // namespace

absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeOrbitPlan(const v1::JobSpec& resolved) {
  CELT_ASSIGN_OR_RETURN(const OrbitOptions options, ToOrbitOptions(resolved.orbit()));
  CELT_ASSIGN_OR_RETURN(StoneOrbit start, OrbitStart(StoneOf(resolved), resolved));
  CELT_ASSIGN_OR_RETURN(const Numerics numerics, ToNumerics(resolved.numerics()));
  CELT_ASSIGN_OR_RETURN(const std::int64_t records, CountRecords(options));
  return std::make_unique<OrbitPlan>(resolved, std::move(start), options, numerics, records);
}

}  // namespace celt::plans
