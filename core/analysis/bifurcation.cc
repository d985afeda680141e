#include "core/analysis/bifurcation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "core/analysis/zero.h"

namespace celt {
namespace {

constexpr double kNearResonance = 0.02;

double NeimarkSackerProduct(std::span<const Multiplier> mu) {
  Multiplier product = 1;
  for (std::size_t i = 0; i < mu.size(); ++i) {
    for (std::size_t j = i + 1; j < mu.size(); ++j) product *= mu[i] * mu[j] - 1.0;
  }
  return product.real();
}

double Discriminant(std::span<const Multiplier> mu) {
  Multiplier product = 1;
  for (std::size_t i = 0; i < mu.size(); ++i) {
    for (std::size_t j = i + 1; j < mu.size(); ++j) product *= (mu[i] - mu[j]) * (mu[i] - mu[j]);
  }
  return product.real();
}

double DoublingProduct(std::span<const Multiplier> mu) {
  Multiplier product = 1;
  for (const Multiplier& multiplier : mu) product *= multiplier + 1.0;
  return product.real();
}

bool SignsDiffer(double a, double b) { return (a < 0) != (b < 0); }

/// The pair for which `distance` is least.
template <typename Distance>
std::vector<Multiplier> ClosestPair(std::span<const Multiplier> mu, Distance distance) {
  std::vector<Multiplier> pair;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mu.size(); ++i) {
    for (std::size_t j = i + 1; j < mu.size(); ++j) {
      if (!(distance(mu[i], mu[j]) < least)) continue;
      least = distance(mu[i], mu[j]);
      pair = {mu[i], mu[j]};
    }
  }
  return pair;
}

Multiplier ClosestTo(double value, std::span<const Multiplier> mu) {
  return *std::min_element(mu.begin(), mu.end(), [value](Multiplier a, Multiplier b) {
    return std::abs(a - value) < std::abs(b - value);
  });
}

std::vector<Multiplier> CriticalOf(BifurcationType type, std::span<const Multiplier> mu) {
  const auto product = [](Multiplier a, Multiplier b) { return std::abs(a * b - 1.0); };
  const auto apart = [](Multiplier a, Multiplier b) { return std::abs(a - b); };
  switch (type) {
    case BifurcationType::kPeriodDoubling:
      return {ClosestTo(-1, mu)};
    case BifurcationType::kFold:
      return {ClosestTo(1, mu)};
    case BifurcationType::kNeimarkSacker:
      return ClosestPair(mu, product);
    case BifurcationType::kMultipliersMeet: {
      const std::vector<Multiplier> pair = ClosestPair(mu, apart);
      const Multiplier mean = (pair[0] + pair[1]) / 2.0;
      return {mean, mean};
    }
    case BifurcationType::kBranchPoint:
      break;
  }
  return {};
}

std::string ResonanceAt(double angle) {
  for (int q = 1; q <= 4; ++q) {
    const double resonant = q == 1 ? 0 : 2 * std::numbers::pi / q;
    if (std::abs(angle - resonant) < kNearResonance) return absl::StrCat("1:", q);
  }
  return "";
}

/// The piece of a branch between two of its points, by the distance along the tangent at the first.
class Piece {
 public:
  Piece(const MapFamily& family, const ContinuationOptions& options, const BranchPoint& before,
        Eigen::VectorXd chord)
      : equation_(EquationOf(family, options)), before_(before), chord_(std::move(chord)) {}

  double length() const { return before_.tangent.dot(chord_); }

  absl::StatusOr<BranchPoint> At(double distance) const {
    const ExtendedPoint guess = equation_.Move(Extended(before_), distance / length(), chord_);
    Corrected corrected = equation_.Correct(guess, before_.tangent);
    if (!corrected.cycle.converged()) return absl::OutOfRangeError(corrected.cycle.message);
    BranchPoint point;
    point.parameter = corrected.parameter;
    point.cycle = std::move(corrected.cycle);
    const auto direction = equation_.DirectionAt(Extended(point), before_.tangent);
    if (!direction.ok()) return direction.status();
    point.tangent = direction->tangent;
    point.orientation = direction->orientation;
    const auto way = equation_.Difference(Extended(point), Extended(before_));
    if (!way.ok()) return way.status();
    point.arclength = before_.arclength + way->norm();
    return point;
  }

 private:
  BranchEquation equation_;
  const BranchPoint& before_;
  Eigen::VectorXd chord_;
};

/// Shrinks the piece to where the test function vanishes.
Bifurcation Locate(BifurcationType type, const Piece& piece, const BranchPoint& before,
                   const BranchPoint& after, double tolerance) {
  BranchPoint low = before;
  BranchPoint high = after;
  const auto test = [&](double distance) -> absl::StatusOr<double> {
    auto point = piece.At(distance);
    if (!point.ok()) return point.status();
    const double value = TestFunction(type, *point);
    (SignsDiffer(value, TestFunction(type, low)) ? high : low) = *std::move(point);
    return value;
  };
  const ZeroResult zero = FindZero(test,
                                   {.a = 0,
                                    .b = piece.length(),
                                    .value_a = TestFunction(type, before),
                                    .value_b = TestFunction(type, after)},
                                   tolerance);
  Bifurcation bifurcation;
  bifurcation.type = type;
  bifurcation.parameter_error = std::abs(high.parameter - low.parameter);
  bifurcation.located = zero.complete;
  const bool low_is_closer = std::abs(TestFunction(type, low)) < std::abs(TestFunction(type, high));
  bifurcation.point = low_is_closer ? std::move(low) : std::move(high);
  return bifurcation;
}

/// What is known of the bifurcation beyond its place.
void Describe(const Map& map, Bifurcation& bifurcation) {
  const CycleReport& cycle = bifurcation.point.cycle;
  bifurcation.critical = CriticalOf(bifurcation.type, cycle.multipliers);
  const auto period = static_cast<int>(cycle.points.size());
  absl::StatusOr<NormalForm> form = NormalForm();
  if (bifurcation.type == BifurcationType::kNeimarkSacker) {
    bifurcation.angle = std::abs(std::arg(bifurcation.critical[0]));
    bifurcation.resonance = ResonanceAt(bifurcation.angle);
    form = NeimarkSackerForm(map, cycle.points.front(), period);
  } else if (bifurcation.type == BifurcationType::kPeriodDoubling) {
    form = PeriodDoublingForm(map, cycle.points.front(), period);
  }
  // Without a coefficient the bifurcation stands, its criticality unknown.
  if (form.ok()) bifurcation.normal_form = *form;
}

/// Two real multipliers with product 1: a neutral saddle, at which nothing happens to the cycle.
bool IsNeutralSaddle(const Bifurcation& bifurcation) {
  return bifurcation.type == BifurcationType::kNeimarkSacker && bifurcation.critical[0].imag() == 0;
}

}  // namespace

std::string_view Name(BifurcationType type) {
  switch (type) {
    case BifurcationType::kPeriodDoubling:
      return "PERIOD_DOUBLING";
    case BifurcationType::kNeimarkSacker:
      return "NEIMARK_SACKER";
    case BifurcationType::kFold:
      return "FOLD";
    case BifurcationType::kBranchPoint:
      return "BRANCH_POINT";
    case BifurcationType::kMultipliersMeet:
      return "MULTIPLIERS_MEET";
  }
  return "";
}

double TestFunction(BifurcationType type, const BranchPoint& point) {
  switch (type) {
    case BifurcationType::kPeriodDoubling:
      return DoublingProduct(point.cycle.multipliers);
    case BifurcationType::kNeimarkSacker:
      return NeimarkSackerProduct(point.cycle.multipliers);
    case BifurcationType::kFold:
      return point.tangent[point.tangent.size() - 1];
    case BifurcationType::kBranchPoint:
      return point.orientation;
    case BifurcationType::kMultipliersMeet:
      return Discriminant(point.cycle.multipliers);
  }
  return 0;
}

absl::StatusOr<std::vector<Bifurcation>> LocateBifurcations(const MapFamily& family,
                                                            const ContinuationOptions& options,
                                                            const BranchPoint& before,
                                                            const BranchPoint& after,
                                                            double tolerance) {
  const auto chord = EquationOf(family, options).Difference(Extended(after), Extended(before));
  if (!chord.ok()) return chord.status();
  const Piece piece(family, options, before, *chord);
  std::vector<Bifurcation> found;
  for (const BifurcationType type : kBifurcationTypes) {
    if (!SignsDiffer(TestFunction(type, before), TestFunction(type, after))) continue;
    Bifurcation bifurcation = Locate(type, piece, before, after, tolerance);
    const auto map = family(bifurcation.point.parameter);
    if (!map.ok()) return map.status();
    Describe(**map, bifurcation);
    if (!IsNeutralSaddle(bifurcation)) found.push_back(std::move(bifurcation));
  }
  std::stable_sort(found.begin(), found.end(), [](const Bifurcation& a, const Bifurcation& b) {
    return a.point.arclength < b.point.arclength;
  });
  return found;
}

}  // namespace celt
