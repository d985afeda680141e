#include "core/analysis/normal_form.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "Eigen/Eigenvalues"
#include "Eigen/LU"
#include "absl/functional/function_ref.h"
#include "absl/status/status.h"

namespace celt {
namespace {

using Complex = std::complex<double>;
using ComplexMatrix = Eigen::MatrixXcd;
using ComplexVector = Eigen::VectorXcd;

/// Steps of the differences, halved from the longest: truncation rules at one end, the map's error
/// at the other, and somewhere between is the best that can be had.
constexpr double kLongestStep = 0.064;
constexpr int kSteps = 14;
constexpr double kSingular = 1e-13;

/// DF^k at each of the starts; nothing for those whose orbits are lost.
std::vector<std::optional<SquareMatrix>> JacobiansAt(const Map& map,
                                                     const std::vector<Point>& starts, int period) {
  const Eigen::Index n = map.dimension();
  std::vector<std::optional<SquareMatrix>> products(starts.size(), SquareMatrix::Identity(n, n));
  const auto multiply = [&products](int i, const Image& image) {
    products[i] = (image.jacobian * *products[i]).eval();
    return true;
  };
  const auto statuses =
      map.AdvanceAll(starts, {.iterates = period, .derivative = Derivative::kJacobian}, multiply);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (!statuses[i].ok()) products[i].reset();
  }
  return products;
}

/// A critical eigenvalue of unit modulus with its eigenvector q and adjoint eigenvector p.
struct Critical {
  Complex value;
  ComplexVector q;
  ComplexVector p;
};

/// The eigenpair of A whose eigenvalue minimises `distance`; q is of unit length.
std::pair<Complex, ComplexVector> Eigenpair(const Eigen::MatrixXd& a,
                                            absl::FunctionRef<double(Complex)> distance) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(a);
  Eigen::Index best = 0;
  for (Eigen::Index i = 1; i < a.rows(); ++i) {
    if (distance(solver.eigenvalues()[i]) < distance(solver.eigenvalues()[best])) best = i;
  }
  return {solver.eigenvalues()[best], solver.eigenvectors().col(best).normalized()};
}

Critical CriticalOf(const SquareMatrix& a, absl::FunctionRef<double(Complex)> distance) {
  const auto [value, q] = Eigenpair(a, distance);
  const auto adjoint = [&distance](Complex mu) { return distance(std::conj(mu)); };
  const auto [conjugate, p] = Eigenpair(a.transpose(), adjoint);
  return {.value = value / std::abs(value), .q = q, .p = p / std::conj(p.dot(q))};
}

/// Derivatives of F^k that the normal forms need, as matrices.
struct Forms {
  ComplexMatrix a;  ///< DF^k
  ComplexMatrix b;  ///< B(q, ·)
  ComplexMatrix c;  ///< C(q, q̄, ·) = C(Re q, Re q, ·) + C(Im q, Im q, ·)
};

/// Central differences with each of kSteps steps; nothing where an orbit was lost.
class Differences {
 public:
  Differences(const Map& map, const Point& x, int period, const SquareMatrix& a,
              const ComplexVector& q)
      : a_(a) {
    std::vector<Point> starts;
    double h = kLongestStep;
    for (int i = 0; i < kSteps; ++i, h /= 2) {
      for (const Eigen::VectorXd& direction :
           {Eigen::VectorXd(q.real()), Eigen::VectorXd(q.imag())}) {
        starts.emplace_back(x + h * direction);
        starts.emplace_back(x - h * direction);
      }
    }
    jacobians_ = JacobiansAt(map, starts, period);
  }

  std::optional<Forms> At(int step) const {
    constexpr int kStarts = 4;
    const auto* at = &jacobians_[static_cast<std::size_t>(kStarts) * step];
    for (int i = 0; i < kStarts; ++i) {
      if (!at[i]) return std::nullopt;
    }
    const double h = kLongestStep * std::pow(0.5, step);
    Forms forms;
    forms.a = a_.cast<Complex>();
    forms.b = (*at[0] - *at[1]) / (2 * h) + Complex(0, 1) * (*at[2] - *at[3]) / (2 * h);
    forms.c = ((*at[0] + *at[1] + *at[2] + *at[3] - 4 * a_) / (h * h)).cast<Complex>();
    return forms;
  }

 private:
  SquareMatrix a_;
  std::vector<std::optional<SquareMatrix>> jacobians_;
};

std::optional<ComplexVector> Solve(const ComplexMatrix& matrix, const ComplexVector& right) {
  const Eigen::PartialPivLU<ComplexMatrix> lu(matrix);
  if (!(lu.rcond() > kSingular)) return std::nullopt;
  return lu.solve(right);
}

std::optional<double> LyapunovCoefficient(const Forms& forms, const Critical& critical) {
  const auto& [value, q, p] = critical;
  const auto one = ComplexMatrix::Identity(q.size(), q.size());
  const auto still = Solve(one - forms.a, forms.b * q.conjugate());
  const auto twice = Solve(value * value * one - forms.a, forms.b * q);
  if (!still || !twice) return std::nullopt;
  const Complex sum =
      p.dot(forms.c * q) + 2.0 * p.dot(forms.b * *still) + p.dot(forms.b.conjugate() * *twice);
  return (std::conj(value) * sum).real() / 2;
}

std::optional<double> DoublingCoefficient(const Forms& forms, const Critical& critical) {
  const auto& [value, q, p] = critical;
  const auto still = Solve(forms.a - ComplexMatrix::Identity(q.size(), q.size()), forms.b * q);
  if (!still) return std::nullopt;
  return (p.dot(forms.c * q) / 6.0 - p.dot(forms.b * *still) / 2.0).real();
}

using Coefficient = std::optional<double> (*)(const Forms&, const Critical&);

/// The coefficient at each step, extrapolated to step 0 from it and the one before; NaN where there
/// is none.
std::vector<double> ExtrapolatedCoefficients(const Differences& differences,
                                             const Critical& critical, Coefficient coefficient) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> extrapolated;
  double before = kNone;
  for (int i = 0; i < kSteps; ++i) {
    const auto forms = differences.At(i);
    const double value = forms ? coefficient(*forms, critical).value_or(kNone) : kNone;
    extrapolated.push_back((4 * value - before) / 3);
    before = value;
  }
  return extrapolated;
}

/// The extrapolated coefficient where it changes least over three successive steps: two could agree
/// by chance.
absl::StatusOr<NormalForm> LeastChanging(const std::vector<double>& extrapolated) {
  NormalForm form;
  form.error = std::numeric_limits<double>::infinity();
  for (std::size_t i = 2; i < extrapolated.size(); ++i) {
    const double here = extrapolated[i - 1];
    const double before = std::abs(here - extrapolated[i - 2]);
    const double after = std::abs(here - extrapolated[i]);
    // Comparisons with NaN are false.
    if (before < form.error && after < form.error) {
      form.coefficient = here;
      form.error = std::max(before, after);
    }
  }
  if (std::isfinite(form.error)) return form;
  return absl::OutOfRangeError(
      "the normal form is undefined: a matrix is singular, or orbits nearby leave the domain");
}

absl::StatusOr<NormalForm> ComputeForm(const Map& map, const Point& x, int period,
                                       absl::FunctionRef<double(Complex)> distance,
                                       Coefficient coefficient) {
  const auto a = JacobiansAt(map, {x}, period).front();
  if (!a) return absl::OutOfRangeError("the orbit of the cycle left the domain");
  const Critical critical = CriticalOf(*a, distance);
  return LeastChanging(
      ExtrapolatedCoefficients(Differences(map, x, period, *a, critical.q), critical, coefficient));
}

Criticality SignOf(const NormalForm& form, double supercritical_sign) {
  if (!(std::abs(form.coefficient) > form.error)) return Criticality::kUnknown;
  return form.coefficient * supercritical_sign > 0 ? Criticality::kSupercritical
                                                   : Criticality::kSubcritical;
}

}  // namespace

std::string_view Name(Criticality criticality) {
  switch (criticality) {
    case Criticality::kUnknown:
      return "unknown";
    case Criticality::kSupercritical:
      return "supercritical";
    case Criticality::kSubcritical:
      return "subcritical";
  }
  return "";
}

absl::StatusOr<NormalForm> NeimarkSackerForm(const Map& map, const Point& x, int period) {
  // Of the pairs, the one nearest to the circle; of the pair, the one above the axis.
  const auto distance = [](Complex mu) {
    constexpr double kNever = 1e300;
    return mu.imag() > 0 ? std::abs(std::abs(mu) - 1) : kNever;
  };
  auto form = ComputeForm(map, x, period, distance, LyapunovCoefficient);
  if (form.ok()) form->criticality = SignOf(*form, -1);
  return form;
}

absl::StatusOr<NormalForm> PeriodDoublingForm(const Map& map, const Point& x, int period) {
  const auto distance = [](Complex mu) { return std::abs(mu + 1.0); };
  auto form = ComputeForm(map, x, period, distance, DoublingCoefficient);
  if (form.ok()) form->criticality = SignOf(*form, 1);
  return form;
}

}  // namespace celt
