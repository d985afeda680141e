#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "core/map/map.h"
#include "google/protobuf/repeated_field.h"

namespace celt::plans {

/// Points as numbers one after the other, and back, exactly.

void PackPoint(const Point& point, google::protobuf::RepeatedField<double>& out);

/// DATA_LOSS: the numbers are not whole points of this dimension.
absl::StatusOr<std::vector<Point>> UnpackPoints(
    const google::protobuf::RepeatedField<double>& numbers, int dimension);

}  // namespace celt::plans
