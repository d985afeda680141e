#include "core/map/sampled_flow.h"

#include "core/integrate/sundials_flow.h"

namespace celt {

absl::StatusOr<Image> SampledFlow::Apply(const Point& x, Direction direction,
                                         Derivative derivative) const {
  if (absl::Status status = CheckPoint(x); !status.ok()) return status;
  const int n = dimension();
  const int tangents = derivative == Derivative::kJacobian ? n : 0;
  const FlowPoint start = {.state = x, .tangents = SquareMatrix::Identity(n, tangents)};
  const double time = direction == Direction::kForward ? time_ : -time_;
  absl::StatusOr<FlowPoint> end = AdvanceFlow(*flow_, start, time, numerics_);
  if (!end.ok()) return end.status();
  Image image = {.point = end->state, .time = time_, .jacobian = {}};
  if (derivative == Derivative::kJacobian) image.jacobian = end->tangents;
  return image;
}

}  // namespace celt
