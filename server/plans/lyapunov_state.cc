#include "server/plans/lyapunov_state.h"

#include <algorithm>

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

}  // namespace

std::string EncodeOrbits(std::span<const FramedOrbit> orbits) {
  OrbitGroup group;
  for (const FramedOrbit& orbit : orbits) {
    Orbit& out = *group.add_orbits();
    out.mutable_point()->Add(orbit.point.begin(), orbit.point.end());
    const auto frame = orbit.frame.reshaped();
    out.mutable_frame()->Add(frame.begin(), frame.end());
  }
  return Serialize(group);
}

absl::StatusOr<std::vector<FramedOrbit>> DecodeOrbits(std::string_view bytes) {
  const auto group = Parse<OrbitGroup>(bytes);
  if (!group.ok()) return group.status();
  std::vector<FramedOrbit> orbits;
  for (const Orbit& in : group->orbits()) {
    FramedOrbit& orbit = orbits.emplace_back();
    orbit.point = ToPoint(in.point());
    const Eigen::Index n = orbit.point.size();
    if (in.frame_size() != n * n)
      return absl::DataLossError("the stored state of an orbit is damaged");
    orbit.frame = Eigen::Map<const Eigen::MatrixXd>(in.frame().data(), n, n);
  }
  return orbits;
}

std::string EncodeSums(std::span<const LyapunovSums> sums) {
  SumsList list;
  for (const LyapunovSums& sum : sums) {
    Sums& out = *list.add_sums();
    out.set_iterates(sum.iterates);
    out.set_time(sum.time);
    out.mutable_log_stretch()->Add(sum.log_stretch.begin(), sum.log_stretch.end());
  }
  return Serialize(list);
}

absl::StatusOr<std::vector<LyapunovSums>> DecodeSums(std::string_view bytes) {
  const auto list = Parse<SumsList>(bytes);
  if (!list.ok()) return list.status();
  std::vector<LyapunovSums> sums;
  for (const Sums& in : list->sums()) {
    sums.push_back(
        {.iterates = in.iterates(), .time = in.time(), .log_stretch = ToPoint(in.log_stretch())});
  }
  return sums;
}

}  // namespace celt::plans
