#include "core/map/henon3d_system.h"

#include <array>
#include <cmath>
#include <memory>

#include "Eigen/LU"
#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace celt {
namespace {

constexpr double kEscape = 1e6;

class Henon3dMap final : public Map {
 public:
  Henon3dMap(double m1, double m2, double a, double b) : m1_(m1), m2_(m2), a_(a), b_(b) {}

  int dimension() const override { return 3; }

  absl::StatusOr<Image> Apply(const Point& x, Direction direction,
                              Derivative derivative) const override {
    if (absl::Status status = CheckPoint(x); !status.ok()) return status;
    const bool forward = direction == Direction::kForward;
    if (!forward && b_ == 0) return absl::UnimplementedError("the map has no inverse for b = 0");
    Image image;
    image.point = forward ? Forward(x) : Backward(x);
    if (!(image.point.cwiseAbs().maxCoeff() <= kEscape)) return Escaped(x);
    if (derivative == Derivative::kJacobian) {
      // The inverse function's derivative is taken at the preimage under F, which is the image
      // here.
      const Eigen::Matrix3d jacobian = JacobianAt(forward ? x : image.point);
      image.jacobian = forward ? jacobian : Eigen::Matrix3d(jacobian.inverse());
    }
    return image;
  }

 private:
  Point Forward(const Point& x) const {
    return Eigen::Vector3d(x[1], x[2], m1_ + b_ * x[0] + m2_ * x[1] + a_ * x[2] - x[2] * x[2]);
  }

  Point Backward(const Point& x) const {
    return Eigen::Vector3d((x[2] - m1_ - m2_ * x[0] - a_ * x[1] + x[1] * x[1]) / b_, x[0], x[1]);
  }

  Eigen::Matrix3d JacobianAt(const Point& x) const {
    return Eigen::Matrix3d{{0, 1, 0}, {0, 0, 1}, {b_, m2_, a_ - 2 * x[2]}};
  }

  static absl::Status Escaped(const Point& x) {
    return absl::OutOfRangeError(
        absl::StrCat("the orbit escapes to infinity from (", x[0], ", ", x[1], ", ", x[2], ")"));
  }

  double m1_, m2_, a_, b_;
};

class Henon3d final : public System {
 public:
  std::string_view name() const override { return "henon3d"; }
  std::string_view description() const override {
    return "Three-dimensional Henon map: x' = y, y' = z, z' = m1 + b x + m2 y + a z - z^2";
  }
  std::span<const ParameterInfo> parameters() const override {
    static constexpr std::array<ParameterInfo, 4> kParameters = {{
        {.name = "m1", .default_value = 0, .unit = "", .description = "constant term"},
        {.name = "m2", .default_value = 0.85, .unit = "", .description = "coefficient of y"},
        {.name = "a", .default_value = 0, .unit = "", .description = "coefficient of z"},
        {.name = "b",
         .default_value = 0.7,
         .unit = "",
         .description = "coefficient of x, the Jacobian determinant"},
    }};
    return kParameters;
  }
  std::span<const std::string_view> coordinates() const override {
    static constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
    return kNames;
  }
  Point DefaultStart() const override { return Eigen::Vector3d(0.1, 0.1, 0.1); }
  Point StartSpread() const override { return Eigen::Vector3d::Constant(0.01); }

 private:
  absl::StatusOr<std::unique_ptr<Map>> Make(const Parameters& p, const Numerics&) const override {
    return std::make_unique<Henon3dMap>(p.at("m1"), p.at("m2"), p.at("a"), p.at("b"));
  }
};

}  // namespace

const System& Henon3dSystem() {
  static const Henon3d system;
  return system;
}

}  // namespace celt
