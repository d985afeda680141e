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

struct Coefficients {
  double m1, m2, a, b;
  double yy, yz, zz;
};

class Henon3dMap final : public Map {
 public:
  explicit Henon3dMap(const Coefficients& coefficients) : c_(coefficients) {}

  int dimension() const override { return 3; }

  absl::StatusOr<Image> Apply(const Point& x, Direction direction,
                              Derivative derivative) const override {
    if (absl::Status status = CheckPoint(x); !status.ok()) return status;
    const bool forward = direction == Direction::kForward;
    if (!forward && c_.b == 0) return absl::UnimplementedError("the map has no inverse for b = 0");
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
  /// Terms that are left out by their coefficients do not show, not even in the sign of a zero.
  double Quadratic(double y, double z) const {
    double sum = c_.zz * z * z;
    if (c_.yz != 0) sum += c_.yz * y * z;
    if (c_.yy != 0) sum += c_.yy * y * y;
    return sum;
  }

  Point Forward(const Point& x) const {
    return Eigen::Vector3d(
        x[1], x[2], c_.m1 + c_.b * x[0] + c_.m2 * x[1] + c_.a * x[2] + Quadratic(x[1], x[2]));
  }

  Point Backward(const Point& x) const {
    return Eigen::Vector3d(
        (x[2] - c_.m1 - c_.m2 * x[0] - c_.a * x[1] - Quadratic(x[0], x[1])) / c_.b, x[0], x[1]);
  }

  Eigen::Matrix3d JacobianAt(const Point& x) const {
    return Eigen::Matrix3d{
        {0, 1, 0},
        {0, 0, 1},
        {c_.b, c_.m2 + 2 * c_.yy * x[1] + c_.yz * x[2], c_.a + c_.yz * x[1] + 2 * c_.zz * x[2]}};
  }

  static absl::Status Escaped(const Point& x) {
    return absl::OutOfRangeError(
        absl::StrCat("the orbit escapes to infinity from (", x[0], ", ", x[1], ", ", x[2], ")"));
  }

  Coefficients c_;
};

class Henon3d final : public System {
 public:
  std::string_view name() const override { return "henon3d"; }
  std::string_view description() const override {
    return "Three-dimensional Henon map: x' = y, y' = z, z' = m1 + b x + m2 y + a z + yy y^2 + "
           "yz y z + zz z^2";
  }
  std::span<const ParameterInfo> parameters() const override {
    static constexpr std::array<ParameterInfo, 7> kParameters = {{
        {.name = "m1", .default_value = 0, .unit = "", .description = "constant term"},
        {.name = "m2", .default_value = 0.85, .unit = "", .description = "coefficient of y"},
        {.name = "a", .default_value = 0, .unit = "", .description = "coefficient of z"},
        {.name = "b",
         .default_value = 0.7,
         .unit = "",
         .description = "coefficient of x, the Jacobian determinant"},
        {.name = "yy", .default_value = 0, .unit = "", .description = "coefficient of y^2"},
        {.name = "yz", .default_value = 0, .unit = "", .description = "coefficient of y z"},
        {.name = "zz", .default_value = -1, .unit = "", .description = "coefficient of z^2"},
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
    return std::make_unique<Henon3dMap>(Coefficients{.m1 = p.at("m1"),
                                                     .m2 = p.at("m2"),
                                                     .a = p.at("a"),
                                                     .b = p.at("b"),
                                                     .yy = p.at("yy"),
                                                     .yz = p.at("yz"),
                                                     .zz = p.at("zz")});
  }
};

}  // namespace

const System& Henon3dSystem() {
  static const Henon3d system;
  return system;
}

}  // namespace celt
