#include "core/analysis/accuracy.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "absl/status/status.h"
#include "core/analysis/frame.h"

namespace celt {
namespace {

using Images = std::vector<std::optional<Image>>;

/// Images with Jacobians; none where the orbit is lost.
absl::StatusOr<Images> ImagesOf(const Map& map, std::span<const Point> sample) {
  Images images(sample.size());
  const auto statuses = map.AdvanceAll(sample, {.iterates = 1, .derivative = Derivative::kJacobian},
                                       [&images](int i, const Image& image) {
                                         images[i] = image;
                                         return true;
                                       });
  for (const absl::Status& status : statuses) {
    if (!status.ok() && !absl::IsOutOfRange(status)) return status;
  }
  return images;
}

double RelativeChange(const SquareMatrix& a, const SquareMatrix& b) {
  const double size = b.cwiseAbs().maxCoeff();
  return size > 0 ? (a - b).cwiseAbs().maxCoeff() / size : 0;
}

/// The entries ln R_ii; empty when the Jacobian is singular.
std::optional<Point> LogStretch(const Image& image, SquareMatrix frame) {
  Point stretch = Point::Zero(frame.rows());
  if (!PushFrame(image.jacobian, frame, stretch)) return std::nullopt;
  return stretch;
}

}  // namespace

absl::StatusOr<MapAccuracy> CompareMaps(const Map& map, const Map& better,
                                        std::span<const Point> sample) {
  const auto images = ImagesOf(map, sample);
  if (!images.ok()) return images.status();
  const auto truths = ImagesOf(better, sample);
  if (!truths.ok()) return truths.status();
  MapAccuracy accuracy;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (!(*images)[i] || !(*truths)[i]) continue;
    const Image& image = *(*images)[i];
    const Image& truth = *(*truths)[i];
    ++accuracy.sample;
    accuracy.map_error = std::max(accuracy.map_error,
                                  map.Difference(image.point, truth.point).cwiseAbs().maxCoeff());
    accuracy.jacobian_error =
        std::max(accuracy.jacobian_error, RelativeChange(image.jacobian, truth.jacobian));
    accuracy.drift = std::max(accuracy.drift, image.drift);
  }
  return accuracy;
}

absl::StatusOr<std::vector<double>> ExponentErrors(const Map& map, const Map& better,
                                                   std::span<const FramedOrbit> sample) {
  std::vector<Point> points;
  points.reserve(sample.size());
  for (const FramedOrbit& orbit : sample) points.push_back(orbit.point);
  const auto images = ImagesOf(map, points);
  if (!images.ok()) return images.status();
  const auto truths = ImagesOf(better, points);
  if (!truths.ok()) return truths.status();
  Point sum = Point::Zero(map.dimension());
  int count = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (!(*images)[i] || !(*truths)[i]) continue;
    const auto stretch = LogStretch(*(*images)[i], sample[i].frame);
    const auto truth = LogStretch(*(*truths)[i], sample[i].frame);
    if (!stretch || !truth) continue;
    sum += *stretch - *truth;
    ++count;
  }
  const Point mean = sum.cwiseAbs() / std::max(count, 1);
  return std::vector<double>(mean.begin(), mean.end());
}

}  // namespace celt
