#include "server/plans/hyperbolicity_state.h"

#include <algorithm>
#include <utility>

#include "server/jobs/status_macros.h"
#include "server/plans/lyapunov_state.h"
#include "server/plans/pack_points.h"
#include "server/plans/serialize.h"
#include "server/plans/state.pb.h"

namespace celt::plans {
namespace {

using Doubles = google::protobuf::RepeatedField<double>;

absl::Status Damaged() {
  return absl::DataLossError("the stored state of the test of pseudo-hyperbolicity is damaged");
}

void PackMatrix(const SquareMatrix& matrix, Doubles& out) {
  const auto entries = matrix.reshaped();
  out.Add(entries.begin(), entries.end());
}

template <typename Numbers>
auto Vector(const Numbers& numbers) {
  return std::vector(numbers.begin(), numbers.end());
}

/// Points in their order, matrices column by column. Precondition: they are all there.
class Reader {
 public:
  Reader(const Doubles& numbers, Eigen::Index dimension) : numbers_(numbers), n_(dimension) {}

  double Number() { return numbers_[next_++]; }
  Point NextPoint() {
    Point point(n_);
    for (double& x : point) x = Number();
    return point;
  }
  SquareMatrix NextMatrix() {
    SquareMatrix matrix(n_, n_);
    for (double& x : matrix.reshaped()) x = Number();
    return matrix;
  }

 private:
  const Doubles& numbers_;
  Eigen::Index n_;
  int next_ = 0;
};

int PendingSize(int n) { return 2 * n + 1 + n * n; }

void PackSplitting(const SplittingOrbit& orbit, HyperbolicityState& state) {
  Orbit& out = *state.mutable_orbit();
  PackPoint(orbit.orbit.point, *out.mutable_point());
  PackMatrix(orbit.orbit.frame, *out.mutable_frame());
  state.set_iterates(orbit.iterates);
  for (const SplittingStep& step : orbit.pending) {
    PackPoint(step.sample.point, *state.mutable_pending());
    PackPoint(step.sample.cu_normal, *state.mutable_pending());
    state.add_pending(step.sample.log_volume);
    PackMatrix(step.jacobian, *state.mutable_pending());
  }
}

absl::StatusOr<SplittingOrbit> UnpackSplitting(const HyperbolicityState& state, int n) {
  const Doubles& frame = state.orbit().frame();
  if (state.orbit().point_size() != n || frame.size() != n * n ||
      state.pending_size() % PendingSize(n) != 0) {
    return Damaged();
  }
  SplittingOrbit orbit;
  orbit.orbit.point = Reader(state.orbit().point(), n).NextPoint();
  orbit.orbit.frame = Reader(frame, n).NextMatrix();
  orbit.iterates = state.iterates();
  Reader reader(state.pending(), n);
  const int pending = state.pending_size() / PendingSize(n);
  for (int i = 0; i < pending; ++i) {
    SplittingStep& step = orbit.pending.emplace_back();
    step.sample.iterate = orbit.iterates - pending + i;
    step.sample.point = reader.NextPoint();
    step.sample.cu_normal = reader.NextPoint();
    step.sample.log_volume = reader.Number();
    step.jacobian = reader.NextMatrix();
  }
  return orbit;
}

void PackCovariance(const CovarianceSums& sums, HyperbolicityState& state) {
  state.set_count(sums.count);
  if (sums.count == 0) return;
  PackPoint(sums.reference, *state.mutable_reference());
  PackPoint(sums.sum, *state.mutable_sum());
  PackMatrix(sums.products, *state.mutable_products());
}

absl::StatusOr<CovarianceSums> UnpackCovariance(const HyperbolicityState& state, int n) {
  CovarianceSums sums;
  sums.count = state.count();
  if (sums.count == 0) return sums;
  if (state.reference_size() != n || state.sum_size() != n || state.products_size() != n * n) {
    return Damaged();
  }
  sums.reference = Reader(state.reference(), n).NextPoint();
  sums.sum = Reader(state.sum(), n).NextPoint();
  sums.products = Reader(state.products(), n).NextMatrix();
  return sums;
}

void PackSums(const HyperbolicitySums& sums, HyperbolicityState& state) {
  state.set_batches(EncodeTally({.sums = sums.batches, .sample = {}}));
  state.set_samples(sums.samples);
  state.mutable_bins()->Add(sums.angles.bins.begin(), sums.angles.bins.end());
  state.set_closest_angle(sums.closest.angle);
  state.set_closest_iterate(sums.closest.iterate);
  PackPoint(sums.closest.point, *state.mutable_closest_point());
  state.mutable_block_minima()->Add(sums.block_minima.begin(), sums.block_minima.end());
  state.set_disagreement(sums.disagreement);
  state.mutable_recent_volume()->Add(sums.recent_volume.begin(), sums.recent_volume.end());
  state.set_log_volume(sums.log_volume);
  state.mutable_least_growth()->Add(sums.least_growth.begin(), sums.least_growth.end());
  for (const LmpPoint& point : sums.lmp_points) {
    state.add_lmp_iterates(point.iterate);
    PackPoint(point.x, *state.mutable_lmp_points());
    PackPoint(point.e, *state.mutable_lmp_points());
  }
}

absl::Status UnpackLmp(const HyperbolicityState& state, int n, HyperbolicitySums& sums) {
  if (state.lmp_points_size() != 2 * n * state.lmp_iterates_size()) return Damaged();
  Reader reader(state.lmp_points(), n);
  for (const std::int64_t iterate : state.lmp_iterates()) {
    LmpPoint& point = sums.lmp_points.emplace_back();
    point.iterate = iterate;
    point.x = reader.NextPoint();
    point.e = reader.NextPoint();
  }
  return absl::OkStatus();
}

absl::StatusOr<HyperbolicitySums> UnpackSums(const HyperbolicityState& state, int n) {
  HyperbolicitySums sums;
  if (state.least_growth_size() != std::ssize(sums.least_growth)) return Damaged();
  CELT_ASSIGN_OR_RETURN(LyapunovTally tally, DecodeTally(state.batches()));
  sums.batches = std::move(tally.sums);
  sums.samples = state.samples();
  sums.angles.bins = Vector(state.bins());
  CELT_ASSIGN_OR_RETURN(const std::vector<Point> closest, UnpackPoints(state.closest_point(), n));
  sums.closest.angle = state.closest_angle();
  sums.closest.iterate = state.closest_iterate();
  if (!closest.empty()) sums.closest.point = closest.front();
  sums.block_minima = Vector(state.block_minima());
  sums.disagreement = state.disagreement();
  sums.recent_volume = Vector(state.recent_volume());
  sums.log_volume = state.log_volume();
  std::copy(state.least_growth().begin(), state.least_growth().end(), sums.least_growth.begin());
  CELT_RETURN_IF_ERROR(UnpackLmp(state, n, sums));
  return sums;
}

}  // namespace

std::string EncodeHyperbolicity(const HyperbolicityWork& work) {
  HyperbolicityState state;
  state.set_done(work.done);
  PackCovariance(work.covariance, state);
  PackSplitting(work.splitting, state);
  PackSums(work.sums, state);
  for (const Point& point : work.sample) PackPoint(point, *state.mutable_sample());
  return Serialize(state);
}

absl::StatusOr<HyperbolicityWork> DecodeHyperbolicity(std::string_view bytes, int dimension) {
  CELT_ASSIGN_OR_RETURN(const HyperbolicityState state, Parse<HyperbolicityState>(bytes));
  HyperbolicityWork work;
  work.done = state.done();
  CELT_ASSIGN_OR_RETURN(work.covariance, UnpackCovariance(state, dimension));
  CELT_ASSIGN_OR_RETURN(work.splitting, UnpackSplitting(state, dimension));
  CELT_ASSIGN_OR_RETURN(work.sums, UnpackSums(state, dimension));
  CELT_ASSIGN_OR_RETURN(work.sample, UnpackPoints(state.sample(), dimension));
  return work;
}

}  // namespace celt::plans
