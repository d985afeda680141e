#include "core/analysis/lyapunov.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "Eigen/QR"
#include "absl/status/status.h"
#include "core/analysis/frame.h"

namespace celt {
namespace {

/// Σ a / Σ d over the batches, with the standard error of a ratio by its linearisation. With equal
/// d it is that of the mean of batch means.
template <typename Numerator, typename Denominator>
Estimate Ratio(std::span<const LyapunovSums> batches, Numerator a, Denominator d) {
  double sum_a = 0;
  double sum_d = 0;
  for (const LyapunovSums& batch : batches) {
    sum_a += a(batch);
    sum_d += d(batch);
  }
  Estimate estimate = {.value = sum_a / sum_d, .standard_error = 0};
  const auto count = static_cast<double>(batches.size());
  if (batches.size() < kFewestBatches) return estimate;
  double squares = 0;
  for (const LyapunovSums& batch : batches) {
    const double residual = a(batch) - estimate.value * d(batch);
    squares += residual * residual;
  }
  estimate.standard_error = std::sqrt(squares * count / (count - 1)) / sum_d;
  return estimate;
}

double Iterates(const LyapunovSums& sums) { return static_cast<double>(sums.iterates); }
double Time(const LyapunovSums& sums) { return sums.time; }

/// The paper's inequalities, each as a combination Σ c_i Λ_i > 0.
std::vector<LyapunovCondition> Conditions(std::span<const LyapunovSums> batches) {
  struct Inequality {
    const char* name;
    Eigen::Vector3d c;
  };
  const std::array<Inequality, 4> inequalities = {
      {{"lambda1 > 0", {1, 0, 0}},
       {"lambda1 + lambda2 > 0", {1, 1, 0}},
       {"lambda1 + lambda2 + lambda3 < 0", {-1, -1, -1}},
       {"lambda3 < lambda2", {0, 1, -1}}}};
  std::vector<LyapunovCondition> conditions;
  for (const Inequality& inequality : inequalities) {
    LyapunovCondition condition;
    condition.name = inequality.name;
    condition.slack = Ratio(
        batches, [&](const LyapunovSums& b) { return inequality.c.dot(b.log_stretch.head<3>()); },
        Iterates);
    condition.holds = condition.slack.value > 0;
    if (condition.slack.standard_error > 0) {
      condition.margin = condition.slack.value / condition.slack.standard_error;
    }
    conditions.push_back(condition);
  }
  return conditions;
}

/// A stream of uniform numbers in [-1, 1): SplitMix64 (Steele, Lea & Flood 2014), the same on every
/// machine.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : state_(seed) {}
  double operator()() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    z ^= z >> 31U;
    return static_cast<double>(z >> 11U) * 0x1p-52 - 1;
  }

 private:
  std::uint64_t state_;
};

/// A random orthonormal frame: an axis of the coordinates may well be invariant, and a frame that
/// starts on it would never turn to the most expanding direction.
SquareMatrix DrawFrame(int dimension, Uniform& uniform) {
  SquareMatrix random(dimension, dimension);
  for (double& entry : random.reshaped()) entry = uniform();
  const Eigen::HouseholderQR<SquareMatrix> qr(random);
  return qr.householderQ() * SquareMatrix::Identity(dimension, dimension);
}

}  // namespace

LyapunovSums& LyapunovSums::operator+=(const LyapunovSums& other) {
  iterates += other.iterates;
  time += other.time;
  if (log_stretch.size() == 0) log_stretch = Point::Zero(other.log_stretch.size());
  if (other.log_stretch.size() != 0) log_stretch += other.log_stretch;
  return *this;
}

absl::StatusOr<std::vector<LyapunovSums>> AdvanceFrames(const Map& map,
                                                        std::span<FramedOrbit> orbits,
                                                        std::int64_t iterates, LyapunovTick tick) {
  std::vector<LyapunovSums> sums(orbits.size());
  std::vector<Point> starts;
  for (const FramedOrbit& orbit : orbits) starts.push_back(orbit.point);
  for (LyapunovSums& sum : sums) sum.log_stretch = Point::Zero(map.dimension());
  std::int64_t done = 0;
  bool cancelled = false;
  bool singular = false;
  const Advance advance = {.iterates = iterates, .derivative = Derivative::kJacobian};
  const auto statuses = map.AdvanceAll(starts, advance, [&](int i, const Image& image) {
    singular = singular || !PushFrame(image.jacobian, orbits[i].frame, sums[i].log_stretch);
    orbits[i].point = image.point;
    sums[i].time += image.time;
    ++sums[i].iterates;
    cancelled = cancelled || !tick(++done);
    return !cancelled && !singular;
  });
  for (const absl::Status& status : statuses) {
    if (!status.ok()) return status;
  }
  if (singular)
    return absl::OutOfRangeError(
        "the Jacobian is singular on the orbit: an exponent is minus infinity");
  if (cancelled) return absl::CancelledError("stopped before the orbits were done");
  return sums;
}

LyapunovReport Summarize(std::span<const LyapunovSums> batches) {
  LyapunovReport report;
  report.batches = std::ssize(batches);
  for (const LyapunovSums& batch : batches) report.iterates += batch.iterates;
  const Eigen::Index n = batches.front().log_stretch.size();
  std::vector<double> exponents;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto stretch = [i](const LyapunovSums& b) { return b.log_stretch[i]; };
    report.per_iterate.push_back(Ratio(batches, stretch, Iterates));
    report.per_time.push_back(Ratio(batches, stretch, Time));
    exponents.push_back(report.per_iterate.back().value);
  }
  const auto volume = [](const LyapunovSums& b) { return b.log_stretch.sum(); };
  report.sum_per_iterate = Ratio(batches, volume, Iterates);
  report.sum_per_time = Ratio(batches, volume, Time);
  report.return_time = Ratio(batches, Time, Iterates);
  std::sort(exponents.begin(), exponents.end(), std::greater<>());
  report.kaplan_yorke_dimension = KaplanYorkeDimension(exponents);
  if (n == 3) report.conditions = Conditions(batches);
  return report;
}

double KaplanYorkeDimension(std::span<const double> exponents) {
  double sum = 0;
  for (std::size_t j = 0; j < exponents.size(); ++j) {
    if (sum + exponents[j] < 0) return static_cast<double>(j) - sum / exponents[j];
    sum += exponents[j];
  }
  return static_cast<double>(exponents.size());
}

std::vector<FramedOrbit> DrawStarts(const Point& start, const Point& spread, int count,
                                    std::uint64_t seed) {
  Uniform uniform(seed);
  std::vector<FramedOrbit> orbits(count);
  for (FramedOrbit& orbit : orbits) {
    orbit.point = start;
    if (count > 1) {
      for (Eigen::Index i = 0; i < start.size(); ++i) orbit.point[i] += spread[i] * uniform();
    }
    orbit.frame = DrawFrame(static_cast<int>(start.size()), uniform);
  }
  return orbits;
}

}  // namespace celt
