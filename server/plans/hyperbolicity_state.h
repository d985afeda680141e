#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "core/analysis/hyperbolicity_sums.h"
#include "core/analysis/splitting.h"
#include "core/analysis/whitening.h"

namespace celt::plans {

/// Where a test of pseudo-hyperbolicity stands.
struct HyperbolicityWork {
  std::int64_t done = 0;  ///< iterates, transient and scouting included
  CovarianceSums covariance;
  SplittingOrbit splitting;
  HyperbolicitySums sums;
  std::vector<Point> sample;  ///< for the accuracy
};

/// As bytes and back, exactly. DATA_LOSS: the bytes are not what was written.
std::string EncodeHyperbolicity(const HyperbolicityWork& work);
absl::StatusOr<HyperbolicityWork> DecodeHyperbolicity(std::string_view bytes, int dimension);

}  // namespace celt::plans
