#include "core/integrate/sundials_flow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/string_view.h"
#include "core/integrate/flow_stepper.h"
#include "core/integrate/ode_stepper.h"

namespace celt {
namespace {

constexpr int kMostSteps = 1'000'000;

using ConstVector = Eigen::Map<const Eigen::VectorXd>;
using ConstMatrix = Eigen::Map<const Eigen::MatrixXd>;

/// The flow with its variational equation: the state first, then the tangent vectors one after the
/// other.
class TangentProblem final : public OdeProblem {
 public:
  TangentProblem(const Flow& flow, int tangents, double tolerance)
      : flow_(flow), n_(flow.dimension()), tangents_(tangents), tolerance_(tolerance) {}

  int size() const override { return n_ * (1 + tangents_); }

  bool Rate(std::span<const double> y, std::span<double> rate) const override {
    const Point x = ConstVector(y.data(), n_);
    if (!flow_.InDomain(x)) return false;
    Eigen::Map<Eigen::VectorXd>(rate.data(), n_) = flow_.Field(x);
    if (tangents_ > 0) {
      Eigen::Map<Eigen::MatrixXd>(rate.data() + n_, n_, tangents_).noalias() =
          flow_.FieldJacobian(x).lazyProduct(ConstMatrix(y.data() + n_, n_, tangents_));
    }
    return true;
  }

  void Weights(std::span<const double> y, std::span<double> weights) const override {
    for (int vector = 0; vector <= tangents_; ++vector) {
      const int first = vector * n_;
      const double size = ConstVector(y.data() + first, n_).norm() / std::sqrt(n_);
      // The least positive number keeps a zero vector's weight finite.
      const double allowed = std::max(tolerance_ * size, std::numeric_limits<double>::min());
      std::fill_n(weights.data() + first, n_, 1 / allowed);
    }
  }

 private:
  const Flow& flow_;
  int n_;
  int tangents_;
  double tolerance_;
};

absl::Status CheckStart(const Flow& flow, const FlowPoint& start, double time) {
  const int n = flow.dimension();
  if (start.state.size() != n || (start.tangents.cols() > 0 && start.tangents.rows() != n)) {
    return absl::InvalidArgumentError(absl::StrCat("start: must have ", n, " components"));
  }
  if (!start.state.allFinite() || !start.tangents.allFinite() || !std::isfinite(time)) {
    return absl::InvalidArgumentError("start: must be finite");
  }
  if (!flow.InDomain(start.state)) {
    return absl::InvalidArgumentError("start: lies outside the domain of the flow");
  }
  return absl::OkStatus();
}

std::vector<double> Pack(const FlowPoint& point) {
  std::vector<double> y(point.state.begin(), point.state.end());
  y.insert(y.end(), point.tangents.data(), point.tangents.data() + point.tangents.size());
  return y;
}

FlowPoint Unpack(std::span<const double> y, const FlowPoint& shape) {
  const auto n = shape.state.size();
  return {ConstVector(y.data(), n), ConstMatrix(y.data() + n, n, shape.tangents.cols())};
}

absl::Status Lost(const OdeStepper& stepper, int dimension, absl::string_view why) {
  return absl::OutOfRangeError(absl::StrCat(
      "orbit lost at t = ", stepper.time(), ", state (",
      absl::StrJoin(stepper.state().first(static_cast<std::size_t>(dimension)), ", "), "): ", why));
}

absl::Status StepTo(OdeStepper& stepper, const Flow& flow, double time) {
  const int n = flow.dimension();
  for (int step = 0; stepper.time() != time; ++step) {
    if (step == kMostSteps)
      return Lost(stepper, n, absl::StrCat("more than ", kMostSteps, " steps"));
    if (const absl::Status status = stepper.Step(time); !status.ok()) {
      return Lost(stepper, n, status.message());
    }
    const ConstVector y(stepper.state().data(), static_cast<Eigen::Index>(stepper.state().size()));
    if (!y.allFinite()) return Lost(stepper, n, "no longer finite");
    if (!flow.InDomain(y.head(n))) return Lost(stepper, n, "outside the domain");
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<FlowPoint> AdvanceFlow(const Flow& flow, const FlowPoint& start, double time,
                                      const Numerics& numerics) {
  if (absl::Status status = CheckStart(flow, start, time); !status.ok()) return status;
  if (time == 0) return start;
  const TangentProblem problem(flow, static_cast<int>(start.tangents.cols()), numerics.tolerance);
  auto stepper = MakeFlowStepper(numerics.engine, problem, Pack(start));
  if (!stepper.ok()) return stepper.status();
  if (absl::Status status = StepTo(**stepper, flow, time); !status.ok()) return status;
  return Unpack((*stepper)->state(), start);
}

}  // namespace celt
