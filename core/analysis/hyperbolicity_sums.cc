#include "core/analysis/hyperbolicity_sums.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

namespace celt {
namespace {

constexpr int kBins = 500;
constexpr double kLeastAngle = 1e-8;  // the first bin takes all below
const double kLogRange = std::log(std::numbers::pi / 2 / kLeastAngle);

void AddAngle(const HyperbolicityOptions& options, const SplittingSample& sample, double angle,
              HyperbolicitySums& sums) {
  sums.angles.Add(angle);
  if (angle < sums.closest.angle) sums.closest = {angle, sample.iterate, sample.point};
  if (sums.samples % options.block == 0) sums.block_minima.push_back(angle);
  sums.block_minima.back() = std::min(sums.block_minima.back(), angle);
}

void AddVolume(const Whitening& whitening, const SplittingSample& sample, HyperbolicitySums& sums) {
  const double here = sums.log_volume + std::log(whitening.Normal(sample.cu_normal).norm());
  sums.log_volume += sample.log_volume;
  std::vector<double>& recent = sums.recent_volume;
  const auto known = static_cast<std::int64_t>(recent.size());
  for (std::size_t i = 0; i < kGrowthWindows.size(); ++i) {
    const std::int64_t window = kGrowthWindows[i];
    if (window > known) continue;
    const double growth = (here - recent[known - window]) / static_cast<double>(window);
    sums.least_growth[i] = std::min(sums.least_growth[i], growth);
  }
  recent.push_back(here);
  if (std::ssize(recent) >= 2 * kGrowthWindows.back()) {
    recent.erase(recent.begin(), recent.end() - kGrowthWindows.back());
  }
}

}  // namespace

void AngleHistogram::Add(double angle) {
  if (bins.empty()) bins.resize(kBins);
  const double place = std::log(std::max(angle, kLeastAngle) / kLeastAngle) / kLogRange;
  ++bins[std::clamp(static_cast<int>(place * kBins), 0, kBins - 1)];
}

std::int64_t AngleHistogram::count() const {
  return std::accumulate(bins.begin(), bins.end(), std::int64_t{0});
}

double AngleHistogram::Quantile(double fraction) const {
  assert(count() > 0);
  const double wanted = fraction * static_cast<double>(count());
  double below = 0;
  for (int i = 0; i < kBins; ++i) {
    const auto here = static_cast<double>(bins[i]);
    if (below + here >= wanted && here > 0) {
      const double place = (i + (wanted - below) / here) / kBins;
      return kLeastAngle * std::exp(place * kLogRange);
    }
    below += here;
  }
  return std::numbers::pi / 2;
}

void AddStretch(const Map& map, const Whitening& whitening, const HyperbolicityOptions& options,
                const SplittingStretch& stretch, HyperbolicitySums& sums) {
  sums.batches.push_back(stretch.sums);
  sums.disagreement = std::max(sums.disagreement, stretch.disagreement);
  for (const SplittingSample& sample : stretch.samples) {
    AddAngle(options, sample, SplittingAngle(whitening, sample), sums);
    AddVolume(whitening, sample, sums);
    if (sums.samples % options.lmp_stride == 0) {
      sums.lmp_points.push_back(
          {sample.iterate, whitening.Apply(map, sample.point), whitening.Direction(sample.stable)});
    }
    ++sums.samples;
  }
}

}  // namespace celt
