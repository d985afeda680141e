#pragma once

#include <array>
#include <cstddef>

#include "core/integrate/fast/lagrange.h"
#include "core/integrate/fast/verner9.h"

namespace celt::fast {

/// Verner's method where the step before was as long: three stages less, for the same order.
///
/// His stages 1 to 4 serve stages 5 and 6 alone, whose states they give with an error of c⁵. A step
/// that follows another has better to start from: the rates of three late stages of the step
/// before, of nearly the full order. One stage, at an eighth of the step, stands in for the four,
/// and the states of all three follow from the polynomial through the rates known,
///
///     x_i = x_0 + h ∫₀^cᵢ p(θ) dθ,   p through θ = 0, the stages of this step so far and, at
///                                    θ = c_j − 1, stages 12, 11, 8 of the step before.
///
/// From stage 7 on nothing changes. The nodes are the choice of some 10⁵ tried by the map's error
/// on attractors of six energies and stones; more of them gain nothing. Compared with Verner's
/// method at the same step, the map and its Jacobian then err 1.0 to 1.6 times as much for steps up
/// to 0.28 in scaled time, 2.4 times at 0.3 and 6 times at 0.5, where extrapolation gets the worst
/// of it.

/// Steps longer than this, in scaled time, do without the step before.
inline constexpr double kLongestTwoStep = 0.28;

/// Stages of the step before that are made use of.
inline constexpr std::array<int, 3> kHistory = {8, 11, 12};

/// The stage in place of stages 1 to 4.
inline constexpr int kEarlyStage = 1;
inline constexpr double kEarlyNode = 0.125;

/// State of a stage = start + Σ value · rate, over stages of this step and of the one before.
template <std::size_t kNow, std::size_t kBefore>
struct TwoStepRow {
  std::array<Coefficient, kNow> now;
  std::array<Coefficient, kBefore> before;
};

template <std::size_t kNow, std::size_t kBefore>
constexpr TwoStepRow<kNow, kBefore> InterpolatingRow(const std::array<int, kNow>& now,
                                                     const std::array<int, kBefore>& before,
                                                     double end) {
  std::array<long double, kNow + kBefore> nodes{};  // so that a weight is rounded once
  for (std::size_t i = 0; i < kNow; ++i) {
    nodes[i] = now[i] == kEarlyStage ? kEarlyNode : kNodes[now[i]];
  }
  for (std::size_t i = 0; i < kBefore; ++i) nodes[kNow + i] = kNodes[before[i]] - 1.0L;
  const auto weights = IntegralWeights<long double>(IntegratedLagrange(nodes), end);
  TwoStepRow<kNow, kBefore> row{};
  for (std::size_t i = 0; i < kNow; ++i) row.now[i] = {now[i], static_cast<double>(weights[i])};
  for (std::size_t i = 0; i < kBefore; ++i)
    row.before[i] = {before[i], static_cast<double>(weights[kNow + i])};
  return row;
}

inline constexpr auto kEarlyRow = InterpolatingRow<1, 3>({0}, {12, 11, 8}, kEarlyNode);
inline constexpr auto kFifthRow = InterpolatingRow<2, 3>({0, kEarlyStage}, {12, 11, 8}, kNodes[5]);
inline constexpr auto kSixthRow = InterpolatingRow<3, 2>({0, kEarlyStage, 5}, {11, 8}, kNodes[6]);

}  // namespace celt::fast
