#include "server/plans/lyapunov_state.h"

#include <algorithm>
#include <utility>

#include "absl/status/status.h"
#include "server/plans/serialize.h"
#include "server/plans/state.pb.h"

namespace celt::plans {
namespace {

Point ToPoint(const google::protobuf::RepeatedField<double>& values) {
  Point point(std::min(values.size(), kMaxDimension));
  for (Eigen::Index i = 0; i < point.size(); ++i) point[i] = values.Get(static_cast<int>(i));
  return point;
}

void Write(const FramedOrbit& orbit, Orbit& out) {
  out.mutable_point()->Add(orbit.point.begin(), orbit.point.end());
  const auto frame = orbit.frame.reshaped();
  out.mutable_frame()->Add(frame.begin(), frame.end());
}

absl::StatusOr<std::vector<FramedOrbit>> Read(
    const google::protobuf::RepeatedPtrField<Orbit>& stored) {
  std::vector<FramedOrbit> orbits;
  orbits.reserve(stored.size());
  for (const Orbit& in : stored) {
    FramedOrbit& orbit = orbits.emplace_back();
    orbit.point = ToPoint(in.point());
    const Eigen::Index n = orbit.point.size();
    if (in.frame_size() != n * n)
      return absl::DataLossError("the stored state of an orbit is damaged");
    orbit.frame = Eigen::Map<const Eigen::MatrixXd>(in.frame().data(), n, n);
  }
  return orbits;
}

void Write(const LyapunovSums& sums, Sums& out) {
  out.set_iterates(sums.iterates);
  out.set_time(sums.time);
  out.mutable_log_stretch()->Add(sums.log_stretch.begin(), sums.log_stretch.end());
}

}  // namespace

std::string EncodeOrbits(std::span<const FramedOrbit> orbits) {
  OrbitGroup group;
  for (const FramedOrbit& orbit : orbits) Write(orbit, *group.add_orbits());
  return Serialize(group);
}

absl::StatusOr<std::vector<FramedOrbit>> DecodeOrbits(std::string_view bytes) {
  const auto group = Parse<OrbitGroup>(bytes);
  if (!group.ok()) return group.status();
  return Read(group->orbits());
}

std::string EncodeTally(const LyapunovTally& tally) {
  LyapunovTallyState state;
  for (const LyapunovSums& sums : tally.sums) Write(sums, *state.add_sums());
  for (const FramedOrbit& orbit : tally.sample) Write(orbit, *state.add_sample());
  return Serialize(state);
}

absl::StatusOr<LyapunovTally> DecodeTally(std::string_view bytes) {
  const auto state = Parse<LyapunovTallyState>(bytes);
  if (!state.ok()) return state.status();
  LyapunovTally tally;
  for (const Sums& in : state->sums()) {
    tally.sums.push_back(
        {.iterates = in.iterates(), .time = in.time(), .log_stretch = ToPoint(in.log_stretch())});
  }
  auto sample = Read(state->sample());
  if (!sample.ok()) return sample.status();
  tally.sample = *std::move(sample);
  return tally;
}

}  // namespace celt::plans
