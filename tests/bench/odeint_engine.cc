#include "tests/bench/odeint_engine.h"

#include <cmath>

#include "absl/status/status.h"
#include "tests/bench/chart.h"
#include "tests/bench/odeint_crossing.h"

namespace celt::bench {
namespace {

/// A state and its tangents as columns.
template <class Form, int kTangents>
using Columns = Eigen::Map<Eigen::Matrix<double, Form::kComponents, 1 + kTangents>>;

}  // namespace

void OdeintEngine::Run(CrossingFeed& feed, Direction direction, Derivative derivative) const {
  CrossingTask task;
  int ticket = 0;
  while (feed.Next(task, ticket)) {
    Crossing crossing;
    absl::Status status;
    if (direction != Direction::kForward) {
      status = absl::UnimplementedError("odeint: forward only");
    } else if (!(derivative == Derivative::kJacobian ? Cross<3>(task, crossing)
                                                     : Cross<0>(task, crossing))) {
      status = absl::OutOfRangeError("odeint: no crossing");
    }
    feed.Done(ticket, status, crossing);
  }
}

template <int kTangents>
bool OdeintEngine::Cross(const CrossingTask& task, Crossing& crossing) const {
  return equations_ == Equations::kFast ? CrossByFast<kTangents>(task, crossing)
                                        : CrossByMomentum<kTangents>(task, crossing);
}

template <int kTangents>
bool OdeintEngine::CrossByMomentum(const CrossingTask& task, Crossing& crossing) const {
  using State = OdeintState<MomentumEquations, kTangents>;
  using InColumns = Columns<MomentumEquations, kTangents>;
  State state{};
  State rate{};
  InColumns columns(state.data());
  columns.col(0) = task.state;
  if constexpr (kTangents > 0) columns.template rightCols<3>() = task.tangents;
  const Eigen::Matrix3d& inertia = stone_.inertia();
  const MomentumEquations equations{.stone = stone_.parameters(),
                                    .inertia11 = inertia(0, 0),
                                    .inertia12 = inertia(0, 1),
                                    .inertia22 = inertia(1, 1),
                                    .cosine = std::cos(section_angle_),
                                    .sine = std::sin(section_angle_)};
  if (!CrossByOdeint<MomentumEquations, kTangents>(equations, tolerance_, state, rate,
                                                   crossing.time)) {
    return false;
  }
  crossing.state = columns.col(0);
  crossing.velocity = InColumns(rate.data()).col(0);
  if constexpr (kTangents > 0) crossing.tangents = columns.template rightCols<3>();
  return true;
}

template <int kTangents>
bool OdeintEngine::CrossByFast(const CrossingTask& task, Crossing& crossing) const {
  using State = OdeintState<FastEquations, kTangents>;
  using InColumns = Columns<FastEquations, kTangents>;
  const double up = task.state[5] > 0 ? 1 : -1;
  State state{};
  State rate{};
  const FastState x = FromMomentum(stone_, task.state);
  InColumns columns(state.data());
  columns.col(0) = x;
  if constexpr (kTangents > 0) {
    columns.template rightCols<3>() = FromMomentum(stone_, x, up, task.tangents);
  }
  const FastEquations equations{.constants = fast::StoneConstants(stone_),
                                .gravity = up * stone_.parameters().gravity,
                                .cosine = std::cos(section_angle_),
                                .sine = std::sin(section_angle_)};
  if (!CrossByOdeint<FastEquations, kTangents>(equations, tolerance_, state, rate, crossing.time)) {
    return false;
  }
  const Chart chart = ToMomentum(stone_, columns.col(0), up);
  crossing.state = chart.state;
  crossing.velocity = chart.derivative * InColumns(rate.data()).col(0);
  if constexpr (kTangents > 0) {
    crossing.tangents = chart.derivative * columns.template rightCols<3>();
  }
  return true;
}

}  // namespace celt::bench
