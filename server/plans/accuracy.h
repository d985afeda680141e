#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "celt/v1/system.pb.h"
#include "core/map/map.h"

namespace celt::plans {

/// The map of a resolved specification at a hundredth of its tolerance, but not below 1e-14, the
/// least there is; at ten times its tolerance where that would be no change (errors are then
/// overstated).
absl::StatusOr<std::unique_ptr<Map>> MakeReferenceMap(const v1::JobSpec& resolved);

/// How accurate `map`, that of the specification, is at the points of `sample`, in the map's own
/// coordinates: against MakeReferenceMap. All zero for maps that are given by a formula. Costs two
/// or three iterates a point; some dozen points of the answer will do.
absl::StatusOr<v1::Accuracy> MeasureAccuracy(const v1::JobSpec& resolved, const Map& map,
                                             std::span<const Point> sample);

/// Points of an answer of `count` points that go into the sample for MeasureAccuracy: 16 of them,
/// spread evenly, or all.
bool IsInSample(std::int64_t index, std::int64_t count);

/// Adds a warning when `error`, the map's part in the error of the quantity named, is not well
/// below `standard_error`, the error that the answer states: not less than a third of it.
void WarnIfNotBelow(std::string_view quantity, double error, double standard_error,
                    v1::Accuracy& accuracy);

}  // namespace celt::plans
