#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "core/analysis/continuation.h"
#include "core/analysis/normal_form.h"
#include "core/map/map_family.h"

namespace celt {

/// What may happen to a cycle along a branch. Each has a test function that changes sign there; μ
/// are the multipliers.
enum class BifurcationType {
  kPeriodDoubling,  ///< Π (μ_i + 1) = det(DF^k + 1)
  kNeimarkSacker,  ///< Π_{i<j} (μ_i μ_j − 1), the determinant of the bialternate product less 1
  kFold,           ///< the parameter's component of the tangent: the branch turns back
  kBranchPoint,    ///< sign of det(∂R/∂y; tangentᵀ): another branch crosses
  kMultipliersMeet,  ///< Π_{i<j} (μ_i − μ_j)²: a pair turns from real to complex or back
};

inline constexpr std::array<BifurcationType, 5> kBifurcationTypes = {
    BifurcationType::kPeriodDoubling, BifurcationType::kNeimarkSacker, BifurcationType::kFold,
    BifurcationType::kBranchPoint, BifurcationType::kMultipliersMeet};

/// "PERIOD_DOUBLING", "NEIMARK_SACKER", "FOLD", "BRANCH_POINT", "MULTIPLIERS_MEET".
std::string_view Name(BifurcationType type);

/// The test function of a type at a point of a branch.
double TestFunction(BifurcationType type, const BranchPoint& point);

struct Bifurcation {
  BifurcationType type = BifurcationType::kFold;
  BranchPoint point;  ///< with the cycle and its multipliers there
  /// Width of the interval of the parameter between two points of opposite sign of the test
  /// function. The map's own error comes on top.
  double parameter_error = 0;
  /// False: corrections failed on the way, and parameter_error is as wide as it was left.
  bool located = false;

  /// The multipliers concerned: the one at −1 or +1, or the pair (of a pair that meets, twice their
  /// mean). Empty at a branch point.
  std::vector<Multiplier> critical;
  double angle = 0;        ///< of a Neimark–Sacker pair e^{±i angle}, in (0, π) [rad]
  std::string resonance;   ///< "1:1", "1:2", "1:3" or "1:4" when the angle is within 0.02 of it
  NormalForm normal_form;  ///< of a period doubling or a Neimark–Sacker bifurcation
};

/// Finds what happened between two successive points of a branch, in the order of travel: the test
/// functions whose signs differ at them. Each is followed to its zero on corrected points in the
/// hyperplanes across the tangent at `before` (Chandrupatla's method), to `tolerance` in arclength.
/// Changes of sign of the Neimark–Sacker function at a pair of real multipliers with product 1 are
/// no bifurcations and left out. An even number of zeros within a step goes unseen:
/// ContinuationOptions::longest_step guards against it. Pure. Status: as of the family.
absl::StatusOr<std::vector<Bifurcation>> LocateBifurcations(const MapFamily& family,
                                                            const ContinuationOptions& options,
                                                            const BranchPoint& before,
                                                            const BranchPoint& after,
                                                            double tolerance = 1e-11);

}  // namespace celt
