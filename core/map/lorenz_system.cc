#include "core/map/lorenz_system.h"

#include <array>
#include <memory>

#include "absl/status/status.h"
#include "core/map/sampled_flow.h"

namespace celt {
namespace {

class LorenzFlow final : public Flow {
 public:
  LorenzFlow(double sigma, double rho, double beta) : sigma_(sigma), rho_(rho), beta_(beta) {}

  int dimension() const override { return 3; }

  Point Field(const Point& x) const override {
    return Eigen::Vector3d(sigma_ * (x[1] - x[0]), x[0] * (rho_ - x[2]) - x[1],
                           x[0] * x[1] - beta_ * x[2]);
  }

  SquareMatrix FieldJacobian(const Point& x) const override {
    return Eigen::Matrix3d{{-sigma_, sigma_, 0}, {rho_ - x[2], -1, -x[0]}, {x[1], x[0], -beta_}};
  }

 private:
  double sigma_, rho_, beta_;
};

class Lorenz final : public System {
 public:
  std::string_view name() const override { return "lorenz"; }
  std::string_view description() const override {
    return "Lorenz flow sampled in time: x' = sigma (y - x), y' = x (rho - z) - y, z' = x y - beta "
           "z";
  }
  std::span<const ParameterInfo> parameters() const override {
    static constexpr std::array<ParameterInfo, 4> kParameters = {{
        {.name = "sigma", .default_value = 10, .unit = "", .description = "Prandtl number"},
        {.name = "rho", .default_value = 28, .unit = "", .description = "relative Rayleigh number"},
        {.name = "beta",
         .default_value = 8.0 / 3.0,
         .unit = "",
         .description = "aspect of the convection cell"},
        {.name = "step",
         .default_value = 0.5,
         .unit = "time",
         .description = "time from sample to sample",
         .lowest = 0,
         .highest = 100,
         .lowest_allowed = false},
    }};
    return kParameters;
  }
  std::span<const std::string_view> coordinates() const override {
    static constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
    return kNames;
  }
  Point DefaultStart() const override { return Eigen::Vector3d(1, 1, 20); }
  Point StartSpread() const override { return Eigen::Vector3d::Constant(1); }

  Engine DefaultEngine() const override { return Engine::kArkode; }

 private:
  absl::StatusOr<std::unique_ptr<Map>> Make(const Parameters& p,
                                            const Numerics& numerics) const override {
    if (numerics.engine == Engine::kFast) {
      return absl::InvalidArgumentError("engine: fast is for celtic-stone; use cvode or arkode");
    }
    return std::make_unique<SampledFlow>(
        std::make_unique<LorenzFlow>(p.at("sigma"), p.at("rho"), p.at("beta")), p.at("step"),
        numerics);
  }
};

}  // namespace

const System& LorenzSystem() {
  static const Lorenz system;
  return system;
}

}  // namespace celt
