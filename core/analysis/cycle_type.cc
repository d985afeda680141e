#include "core/analysis/cycle_type.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/str_cat.h"

namespace celt {
namespace {

CycleKind KindOf(const CycleType& type) {
  if (type.neutral > 0) return CycleKind::kNonHyperbolic;
  const bool complex = std::find(type.sides.begin(), type.sides.end(), 0) != type.sides.end();
  if (type.stable > 0 && type.unstable > 0) {
    return complex ? CycleKind::kSaddleFocus : CycleKind::kSaddle;
  }
  return complex ? CycleKind::kFocus : CycleKind::kNode;
}

std::string NameOf(const CycleType& type) {
  const std::string stability = type.unstable > 0 ? "unstable " : "stable ";
  const std::string dimensions = absl::StrCat(" ", type.stable, "-", type.unstable);
  switch (type.kind) {
    case CycleKind::kNode:
      return stability + "node";
    case CycleKind::kFocus:
      return stability + "focus";
    case CycleKind::kSaddle:
      return "saddle" + dimensions;
    case CycleKind::kSaddleFocus:
      return "saddle-focus" + dimensions;
    case CycleKind::kNonHyperbolic:
      return "non-hyperbolic" + dimensions;
  }
  return "";
}

CycleCondition Positive(const char* name, double margin) {
  return {.name = name, .holds = margin > 0, .margin = margin};
}

}  // namespace

CycleType TypeOf(std::span<const Multiplier> multipliers, double tolerance) {
  CycleType type;
  for (const Multiplier& mu : multipliers) {
    const double excess = std::abs(mu) - 1;
    const bool neutral = std::abs(excess) <= tolerance;
    ++(neutral ? type.neutral : excess < 0 ? type.stable : type.unstable);
    const int sign = mu.real() < 0 ? -1 : 1;
    type.sides.push_back(mu.imag() != 0 ? 0 : sign);
  }
  type.kind = KindOf(type);
  type.name = NameOf(type);
  return type;
}

std::vector<CycleCondition> LorenzConditions(std::span<const Multiplier> multipliers) {
  if (multipliers.size() != 3) return {};
  const Multiplier gamma = multipliers[0];
  const Multiplier lambda1 = multipliers[1];
  const Multiplier lambda2 = multipliers[2];
  const double imaginary =
      std::max({std::abs(gamma.imag()), std::abs(lambda1.imag()), std::abs(lambda2.imag())});
  return {
      {.name = "real multipliers", .holds = imaginary == 0, .margin = 0 - imaginary},
      Positive("|lambda2| < |lambda1|", std::abs(lambda1) - std::abs(lambda2)),
      Positive("|lambda1| < 1", 1 - std::abs(lambda1)),
      Positive("|gamma| > 1", std::abs(gamma) - 1),
      Positive("lambda1 > 0", lambda1.real()),
      Positive("lambda2 < 0", -lambda2.real()),
      Positive("gamma < -1", -1 - gamma.real()),
      Positive("|lambda1 gamma| > 1", std::abs(lambda1 * gamma) - 1),
  };
}

}  // namespace celt
