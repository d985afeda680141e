#include "server/plans/pack_points.h"

namespace celt::plans {

void PackPoint(const Point& point, google::protobuf::RepeatedField<double>& out) {
  out.Add(point.begin(), point.end());
}

absl::StatusOr<std::vector<Point>> UnpackPoints(
    const google::protobuf::RepeatedField<double>& numbers, int dimension) {
  if (dimension < 1 || dimension > kMaxDimension || numbers.size() % dimension != 0) {
    return absl::DataLossError("the stored points of the job are damaged");
  }
  std::vector<Point> points;
  for (int i = 0; i < numbers.size(); i += dimension) {
    points.emplace_back(Eigen::Map<const Eigen::VectorXd>(numbers.data() + i, dimension));
  }
  return points;
}

}  // namespace celt::plans
