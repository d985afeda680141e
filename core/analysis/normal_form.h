#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "core/analysis/shooting.h"
#include "core/map/map.h"

namespace celt {

/// Which way a bifurcation goes: whether what is born is stable within the centre manifold.
enum class Criticality {
  kUnknown,        ///< not computed, or zero within its error
  kSupercritical,  ///< stable
  kSubcritical,    ///< unstable
};

/// "unknown", "supercritical", "subcritical".
std::string_view Name(Criticality criticality);

/// The cubic coefficient of the normal form on the centre manifold.
struct NormalForm {
  double coefficient = 0;
  /// How much it changed when the step of the differences was halved and doubled, at the step where
  /// that was least: covers both truncation and the map's error.
  double error = 0;
  Criticality criticality = Criticality::kUnknown;
};

/// The first Lyapunov coefficient of a cycle (its first point and period) with a pair e^{±iθ} of
/// multipliers: with A = DF^k, A q = e^{iθ} q, Aᵀ p = e^{−iθ} p, ⟨q, q⟩ = ⟨p, q⟩ = 1 and B, C the
/// second and third derivatives of F^k (Kuznetsov 2004, §5.4),
///
///     d = ½ Re e^{−iθ} [⟨p, C(q,q,q̄)⟩ + 2⟨p, B(q, (1−A)⁻¹ B(q,q̄))⟩
///                       + ⟨p, B(q̄, (e^{2iθ}−A)⁻¹ B(q,q))⟩].
///
/// d < 0: a stable invariant curve appears on the unstable side; supercritical. B and C come from
/// central differences of DF^k along Re q and Im q. Means nothing at the strong resonances 1:1 …
/// 1:4. Status as of Map::Apply; OUT_OF_RANGE when a matrix to invert is singular.
absl::StatusOr<NormalForm> NeimarkSackerForm(const Map& map, const Point& x, int period);

/// The coefficient of a period doubling: with A q = −q, Aᵀ p = −p, ⟨q, q⟩ = ⟨p, q⟩ = 1 (Kuznetsov
/// 2004, §5.4),
///
///     c = ⟨p, C(q,q,q)⟩/6 − ½⟨p, B(q, (A−1)⁻¹ B(q,q))⟩.
///
/// c > 0: the doubled cycle is stable and lives where the single one is not; supercritical.
absl::StatusOr<NormalForm> PeriodDoublingForm(const Map& map, const Point& x, int period);

}  // namespace celt
