#include "server/plans/manifold_state.h"

#include "server/jobs/status_macros.h"
#include "server/plans/pack_points.h"
#include "server/plans/serialize.h"
#include "server/plans/state.pb.h"

namespace celt::plans {

std::string EncodeSide(const ManifoldSide& side) {
  ManifoldSideState state;
  state.set_side(side.side);
  state.set_step(side.step);
  state.set_generation(side.generation);
  state.mutable_s()->Add(side.s.begin(), side.s.end());
  for (const Point& point : side.points) PackPoint(point, *state.mutable_points());
  for (const Point& point : side.images) PackPoint(point, *state.mutable_images());
  state.set_refining(side.refining);
  state.set_visited(side.visited);
  state.set_arc_length(side.arc_length);
  state.set_written(side.written);
  state.set_end(static_cast<int>(side.end));
  state.set_message(side.message);
  state.set_done(side.done);
  return Serialize(state);
}

absl::StatusOr<ManifoldSide> DecodeSide(std::string_view bytes, int dimension) {
  CELT_ASSIGN_OR_RETURN(const ManifoldSideState state, Parse<ManifoldSideState>(bytes));
  ManifoldSide side;
  side.side = state.side();
  side.step = state.step();
  side.generation = state.generation();
  side.s.assign(state.s().begin(), state.s().end());
  CELT_ASSIGN_OR_RETURN(side.points, UnpackPoints(state.points(), dimension));
  CELT_ASSIGN_OR_RETURN(side.images, UnpackPoints(state.images(), dimension));
  side.refining = state.refining();
  side.visited = state.visited();
  side.arc_length = state.arc_length();
  side.written = state.written();
  side.end = static_cast<ManifoldEnd>(state.end());
  side.message = state.message();
  side.done = state.done();
  if (side.s.size() != side.points.size()) {
    return absl::DataLossError("the stored state of a manifold is damaged");
  }
  return side;
}

}  // namespace celt::plans
