#include "tests/bench/tool.h"

#include <algorithm>
#include <numbers>

#include "core/map/celtic_stone_system.h"
#include "core/map/section_map.h"
#include "tests/bench/odeint_engine.h"
#include "tests/core/reference.h"

namespace celt::bench {
namespace {

constexpr double kEnergy = 752;
constexpr double kAngle = std::numbers::pi;

Engine EngineOf(const std::string& name) {
  if (name == "cvode") return Engine::kCvode;
  return name == "arkode" ? Engine::kArkode : Engine::kFast;
}

}  // namespace

const std::vector<Tool>& Tools() {
  static const std::vector<Tool> tools = {
      {"fast", 1e-10},          {"fast", 1.4e-11},      {"fast", 1e-11},
      {"fast", 1e-12},          {"odeint", 1e-9},       {"odeint", 3e-10},
      {"odeint", 2.5e-10},      {"odeint", 1e-10},      {"odeint", 3e-11},
      {"odeint", 1e-11},        {"odeint-fast", 1e-9},  {"odeint-fast", 3e-10},
      {"odeint-fast", 2.5e-10}, {"odeint-fast", 1e-10}, {"odeint-fast", 3e-11},
      {"odeint-fast", 1e-11},   {"arkode", 3e-10},      {"arkode", 1e-10},
      {"arkode", 1e-11},        {"cvode", 1e-12},       {"cvode", 3e-13},
      {"cvode", 1e-13},         {"cvode", 3e-14}};
  return tools;
}

std::unique_ptr<Map> MakeMap(const Tool& tool) {
  if (tool.name.starts_with("odeint")) {
    const CelticStone stone{StoneParameters{}};
    const Equations equations =
        tool.name == "odeint-fast" ? Equations::kFast : Equations::kMomentum;
    return std::make_unique<SectionMap>(
        stone, kEnergy, kAngle,
        std::make_unique<OdeintEngine>(stone, kAngle, tool.tolerance, equations));
  }
  return CelticStoneSystem()
      .MakeMap({}, {.tolerance = tool.tolerance, .engine = EngineOf(tool.name)})
      .value();
}

std::vector<Point> Starts(int count) {
  const std::vector<ReferenceIterate> reference = ReferenceIterates();
  std::vector<Point> starts;
  for (int i = 0; i < count; ++i) starts.emplace_back(reference[i % reference.size()].point);
  return starts;
}

Errors ErrorsOf(const Map& map) {
  Errors errors;
  for (const ReferenceIterate& iterate : ReferenceIterates()) {
    const auto error = [&](const Image& image) {
      return map.Difference(image.point, iterate.image).cwiseAbs().maxCoeff();
    };
    const Image image =
        map.Apply(iterate.point, Direction::kForward, Derivative::kJacobian).value();
    errors.map = std::max(errors.map, error(image));
    errors.alone =
        std::max(errors.alone,
                 error(map.Apply(iterate.point, Direction::kForward, Derivative::kNone).value()));
    errors.jacobian =
        std::max(errors.jacobian, (image.jacobian - iterate.jacobian).cwiseAbs().maxCoeff() /
                                      iterate.jacobian.cwiseAbs().maxCoeff());
  }
  return errors;
}

}  // namespace celt::bench
