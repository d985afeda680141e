#include "tests/bench/odeint_engine.h"

#include <cmath>

#include "absl/status/status.h"
#include "core/integrate/fast/coordinates.h"
#include "tests/bench/odeint_crossing.h"

namespace celt::bench {

void OdeintEngine::Run(CrossingFeed& feed, Direction direction, Derivative derivative) const {
  CrossingTask task;
  int ticket = 0;
  while (feed.Next(task, ticket)) {
    Crossing crossing;
    absl::Status status = absl::UnimplementedError("odeint: forward only");
    if (direction == Direction::kForward) {
      status =
          derivative == Derivative::kJacobian ? Cross<3>(task, crossing) : Cross<0>(task, crossing);
    }
    feed.Done(ticket, status, crossing);
  }
}

template <int kTangents>
absl::Status OdeintEngine::Cross(const CrossingTask& task, Crossing& crossing) const {
  using Columns = Eigen::Map<Eigen::Matrix<double, 5, 1 + kTangents>>;
  const double up = task.state[5] > 0 ? 1 : -1;
  OdeintState<kTangents> state{};
  OdeintState<kTangents> rate{};
  const fast::FastState x = fast::FromMomentum(stone_, task.state);
  Columns columns(state.data());
  columns.col(0) = x;
  if constexpr (kTangents > 0) {
    columns.template rightCols<3>() = fast::FromMomentum(stone_, x, up, task.tangents);
  }
  const OdeintProblem problem{.constants = fast::StoneConstants(stone_),
                              .gravity = up * stone_.parameters().gravity,
                              .cosine = std::cos(section_angle_),
                              .sine = std::sin(section_angle_),
                              .tolerance = tolerance_};
  if (!CrossByOdeint<kTangents>(problem, state, rate, crossing.time)) {
    return absl::OutOfRangeError("odeint: no crossing");
  }
  const fast::Chart chart = fast::ToMomentum(stone_, columns.col(0), up);
  crossing.state = chart.state;
  crossing.velocity = chart.derivative * Columns(rate.data()).col(0);
  if constexpr (kTangents > 0) {
    crossing.tangents = chart.derivative * columns.template rightCols<3>();
  }
  return absl::OkStatus();
}

}  // namespace celt::bench
