#include "client/cli/system_options.h"

#include <array>
#include <utility>

#include "absl/strings/str_cat.h"
#include "client/cli/option.h"
#include "client/cli/parse.h"

namespace celt::cli {
namespace {

constexpr char kStone[] = "celtic-stone";
constexpr char kStoneGroup[] = "Celtic stone";
constexpr char kSystemGroup[] = "Other systems";
constexpr char kNumericsGroup[] = "Numerics";

/// An option of the stone that is one number and one parameter of the same meaning.
struct StoneNumber {
  const char* option;
  const char* parameter;
  const char* value;
  const char* help;
};

constexpr std::array<StoneNumber, 7> kStoneNumbers = {{
    {"--energy", "energy", "E", "energy H of the level (default 752)"},
    {"--delta", "delta", "RAD", "angle from the geometric to the inertial axes (default 0.485)"},
    {"--mass", "mass", "M", "mass (default 1)"},
    {"--gravity", "gravity", "G", "acceleration of gravity (default 100)"},
    {"--height", "height", "H", "of the centre of mass above the vertex (default 1)"},
    {"--section-angle", "section_angle", "RAD", "the section is g = this angle (default pi)"},
    {"--crossing", "crossing", "SIGN", "1: crossed with g increasing (default), -1: decreasing"},
}};

absl::Status NotOfSystem(const std::string& option, const std::string& system) {
  return absl::InvalidArgumentError(
      absl::StrCat(option, ": belongs to the celtic-stone; the parameters of ", system,
                   " are given by --set name=value"));
}

absl::Status SetTwice(const std::string& option, const std::string& parameter) {
  return absl::InvalidArgumentError(
      absl::StrCat(option, ": the parameter ", parameter, " is given by --set as well"));
}

}  // namespace

void SystemOptions::AddTo(CLI::App& app) {
  AddStone(app);
  AddSystem(app);
  AddNumerics(app);
}

void SystemOptions::AddStone(CLI::App& app) {
  for (const StoneNumber& number : kStoneNumbers) {
    AddNumber(app, number.option, numbers_[number.parameter],
              {kStoneGroup, number.value, number.help});
  }
  AddNumbers(app, "--inertia", {"I1", "I2", "I3"}, inertia_,
             {kStoneGroup, "I1,I2,I3", "principal moments of inertia (default 2,6,7)"});
  AddNumbers(app, "--radii", {"A1", "A2"}, radii_,
             {kStoneGroup, "A1,A2", "radii of curvature at the vertex (default 9,4)"});
  AddChoice(app, "--frame", {"body", "paper"}, frame_,
            {kStoneGroup, "body|paper", "frame of the points given and printed (default body)"});
}

void SystemOptions::AddSystem(CLI::App& app) {
  app.add_option("--system", system_,
                 "celtic-stone (default), lorenz, henon3d; see 'celt server info'")
      ->group(kSystemGroup)
      ->type_name("NAME");
  app.add_option_function<std::vector<std::string>>(
         "--set",
         [this](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) {
             auto assignment = ParseAssignment(text);
             if (!assignment.ok()) {
               throw CLI::ValidationError("--set", std::string(assignment.status().message()));
             }
             if (!set_.insert(*std::move(assignment)).second) {
               throw CLI::ValidationError("--set", absl::StrCat("'", text, "' comes twice"));
             }
           }
         },
         "a parameter of any system; may be repeated")
      ->allow_extra_args(false)
      ->group(kSystemGroup)
      ->type_name("NAME=VALUE");
}

void SystemOptions::AddNumerics(CLI::App& app) {
  AddNumber(
      app, "--tolerance", tolerance_,
      {kNumericsGroup, "EPS", "error of a step, 1e-14 to 1e-3 (default 1e-11, 1e-13 of cycles)"});
  AddChoice(app, "--engine", {"cvode", "arkode", "fast"}, engine_,
            {kNumericsGroup, "cvode|arkode|fast",
             "code that advances the flow (default: fast; for lorenz arkode)"});
}

std::vector<SystemOptions::StoneValue> SystemOptions::StoneValues() const {
  std::vector<StoneValue> values;
  for (const StoneNumber& number : kStoneNumbers) {
    const auto& given = numbers_.at(number.parameter);
    if (given) values.push_back({number.option, number.parameter, *given});
  }
  const auto add_numbered = [&values](const std::optional<std::vector<double>>& given,
                                      const char* option, const char* stem) {
    for (std::size_t i = 0; given && i < given->size(); ++i) {
      values.push_back({option, absl::StrCat(stem, "_", i + 1), (*given)[i]});
    }
  };
  add_numbered(inertia_, "--inertia", "inertia");
  add_numbered(radii_, "--radii", "radius");
  return values;
}

absl::Status SystemOptions::Fill(v1::JobSpec& spec) const {
  if (!system_.empty()) spec.mutable_system()->set_name(system_);
  for (const auto& [name, value] : set_) {
    (*spec.mutable_system()->mutable_parameters())[name] = value;
  }
  for (const auto& [option, parameter, value] : StoneValues()) {
    if (!IsStone(spec)) return NotOfSystem(option, system_);
    const bool is_new =
        spec.mutable_system()->mutable_parameters()->insert({parameter, value}).second;
    if (!is_new) return SetTwice(option, parameter);
  }
  if (frame_ && !IsStone(spec)) return NotOfSystem("--frame", system_);
  FillNumerics(spec);
  return absl::OkStatus();
}

void SystemOptions::FillNumerics(v1::JobSpec& spec) const {
  if (frame_) spec.set_frame(*frame_ == 0 ? v1::FRAME_BODY : v1::FRAME_PAPER);
  if (tolerance_) spec.mutable_numerics()->set_tolerance(*tolerance_);
  constexpr std::array kEngines = {v1::ENGINE_CVODE, v1::ENGINE_ARKODE, v1::ENGINE_FAST};
  if (engine_) spec.mutable_numerics()->set_engine(kEngines.at(static_cast<std::size_t>(*engine_)));
}

bool IsStone(const v1::JobSpec& spec) {
  return spec.system().name().empty() || spec.system().name() == kStone;
}

absl::StatusOr<v1::Point> MakePoint(const v1::JobSpec& spec, const std::vector<double>& coordinates,
                                    const std::string& option) {
  v1::Point point;
  if (!IsStone(spec)) {
    point.mutable_x()->Add(coordinates.begin(), coordinates.end());
    return point;
  }
  if (coordinates.size() != 3) {
    return absl::InvalidArgumentError(
        absl::StrCat(option, ": ", coordinates.size(), " numbers where 3 are due: l,L/G,H/G"));
  }
  point.set_l(coordinates[0]);
  point.set_l_over_g(coordinates[1]);
  point.set_h_over_g(coordinates[2]);
  return point;
}

}  // namespace celt::cli
