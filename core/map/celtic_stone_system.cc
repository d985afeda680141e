#include "core/map/celtic_stone_system.h"

#include <array>
#include <memory>
#include <numbers>
#include <utility>

#include "absl/strings/str_cat.h"
#include "core/integrate/section_engine.h"
#include "core/map/section_map.h"
#include "core/model/celtic_stone.h"

namespace celt {
namespace {

constexpr StoneParameters kPaper;

constexpr ParameterInfo Positive(std::string_view name, double value,
                                 std::string_view description) {
  return {.name = name,
          .default_value = value,
          .unit = "",
          .description = description,
          .lowest = 0,
          .lowest_allowed = false};
}

constexpr std::array<ParameterInfo, 12> kParameters = {{
    {.name = "energy",
     .default_value = 752,
     .unit = "",
     .description = "E of the level H = (M, omega)/2 - m g (r, gamma) = E"},
    {.name = "delta",
     .default_value = kPaper.delta,
     .unit = "rad",
     .description = "angle from the geometric to the inertial horizontal axes"},
    Positive("inertia_1", kPaper.inertia1,
             "principal moment of inertia I1 about the centre of mass"),
    Positive("inertia_2", kPaper.inertia2,
             "principal moment of inertia I2 about the centre of mass"),
    Positive("inertia_3", kPaper.inertia3,
             "moment of inertia I3 about the vertical axis of the body"),
    Positive("mass", kPaper.mass, "m"),
    Positive("gravity", kPaper.gravity, "g"),
    Positive("radius_1", kPaper.radius1, "principal radius of curvature a1 at the vertex"),
    Positive("radius_2", kPaper.radius2, "principal radius of curvature a2 at the vertex"),
    Positive("height", kPaper.height, "h of the centre of mass above the vertex"),
    {.name = "section_angle",
     .default_value = std::numbers::pi,
     .unit = "rad",
     .description = "g of the section in the body frame"},
    {.name = "crossing",
     .default_value = 1,
     .unit = "",
     .description = "1: the section is crossed with g increasing; -1: decreasing",
     .lowest = -1,
     .highest = 1},
}};

absl::StatusOr<Crossings> CrossingsOf(double crossing) {
  if (crossing == 1) return Crossings::kIncreasing;
  if (crossing == -1) return Crossings::kDecreasing;
  return absl::InvalidArgumentError(absl::StrCat(
      "crossing: ", crossing, " is not allowed; it is 1 (g increasing) or -1 (decreasing)"));
}

class CelticStoneSections final : public System {
 public:
  std::string_view name() const override { return "celtic-stone"; }
  std::string_view description() const override {
    return "Section map of the Celtic stone, an elliptic paraboloid that rolls on a plane without "
           "slipping";
  }
  std::span<const ParameterInfo> parameters() const override { return kParameters; }
  std::span<const std::string_view> coordinates() const override {
    static constexpr std::array<std::string_view, 3> kNames = {"l", "l_over_g", "h_over_g"};
    return kNames;
  }
  Point DefaultStart() const override {
    return Eigen::Vector3d(2.147462384985, -0.669144118368, -0.384701258034);
  }
  Point StartSpread() const override { return Eigen::Vector3d::Constant(1e-3); }

  Engine DefaultEngine() const override { return kDefaultSectionEngine; }

 private:
  absl::StatusOr<std::unique_ptr<Map>> Make(const Parameters& parameters,
                                            const Numerics& numerics) const override {
    const StoneParameters stone_parameters = StoneParametersOf(parameters);
    if (absl::Status status = CheckStone(stone_parameters); !status.ok()) return status;
    const CelticStone stone(stone_parameters);
    const double angle = parameters.at("section_angle");
    const auto crossings = CrossingsOf(parameters.at("crossing"));
    if (!crossings.ok()) return crossings.status();
    auto engine = MakeSectionEngine(stone, {angle, *crossings}, numerics);
    if (!engine.ok()) return engine.status();
    return std::make_unique<SectionMap>(stone, parameters.at("energy"), angle, *std::move(engine));
  }
};

}  // namespace

StoneParameters StoneParametersOf(const Parameters& parameters) {
  return {.inertia1 = parameters.at("inertia_1"),
          .inertia2 = parameters.at("inertia_2"),
          .inertia3 = parameters.at("inertia_3"),
          .mass = parameters.at("mass"),
          .gravity = parameters.at("gravity"),
          .radius1 = parameters.at("radius_1"),
          .radius2 = parameters.at("radius_2"),
          .height = parameters.at("height"),
          .delta = parameters.at("delta")};
}

const System& CelticStoneSystem() {
  static const CelticStoneSections system;
  return system;
}

}  // namespace celt
