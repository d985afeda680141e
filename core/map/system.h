#pragma once

#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "core/map/map.h"

namespace celt {

/// Values of a system's parameters by name; those left out take their defaults.
using Parameters = std::map<std::string, double, std::less<>>;

/// A parameter that a system takes: what messages, help texts and validation say of it.
struct ParameterInfo {
  std::string_view name;  ///< snake_case, as in specifications and on sweep axes
  double default_value = 0;
  std::string_view unit;         ///< empty for a pure number
  std::string_view description;  ///< one line, with the formula that it stands in where one helps
  double lowest = -std::numeric_limits<double>::infinity();  ///< values below are refused
  double highest = std::numeric_limits<double>::infinity();  ///< values above are refused
  bool lowest_allowed = true;                                ///< false: `lowest` itself is refused
  bool highest_allowed = true;
};

/// The allowed values as an interval, such as "(0, inf)".
std::string RangeText(const ParameterInfo& info);

/// Which code advances a flow. All agree within the errors that each states.
enum class Engine { kDefault, kCvode, kArkode, kFast };

/// How accurately, and by which code, a map made from a flow is computed. Maps given by a formula
/// ignore it.
struct Numerics {
  /// Error of one step of the integrator, relative to the size of the solution. In [1e-14, 1e-3].
  double tolerance = 1e-11;
  Engine engine = Engine::kDefault;
};

/// A family of maps: what a user names with `--system`. A new system is one file that defines one
/// of these and one line in system.cc that lists it. Stateless and safe to use from many threads.
class System {
 public:
  virtual ~System() = default;

  virtual std::string_view name() const = 0;
  virtual std::string_view description() const = 0;
  virtual std::span<const ParameterInfo> parameters() const = 0;
  /// Names of the coordinates of a point, in order.
  virtual std::span<const std::string_view> coordinates() const = 0;

  /// A start in the basin of the attractor that the system is known for, at its default parameters.
  virtual Point DefaultStart() const = 0;
  /// Half-widths of the box around a start from which the starts of independent orbits are drawn.
  virtual Point StartSpread() const = 0;
  /// The engine that Engine::kDefault stands for in this system's maps; kDefault itself when they
  /// are given by a formula and need none.
  virtual Engine DefaultEngine() const { return Engine::kDefault; }

  /// Makes the map. INVALID_ARGUMENT names the field, its value and what is allowed; unknown names
  /// are refused.
  absl::StatusOr<std::unique_ptr<Map>> MakeMap(const Parameters& parameters,
                                               const Numerics& numerics) const;

  /// All parameters with their values, defaults filled in; refuses unknown names, NaNs and values
  /// out of range.
  absl::StatusOr<Parameters> Resolve(const Parameters& given) const;

 private:
  /// `parameters` is complete and each value is in its range; what is left to check is what
  /// concerns several at once.
  virtual absl::StatusOr<std::unique_ptr<Map>> Make(const Parameters& parameters,
                                                    const Numerics& numerics) const = 0;
};

/// Every system there is, the Celtic stone first.
std::span<const System* const> AllSystems();

/// INVALID_ARGUMENT with the names that exist when there is no such system.
absl::StatusOr<const System*> FindSystem(std::string_view name);

/// INVALID_ARGUMENT unless the tolerance lies in its range.
absl::Status CheckNumerics(const Numerics& numerics);

/// Refuses anything but a finite point of the system's dimension, naming the coordinate.
absl::Status CheckPoint(const System& system, const Point& point);

}  // namespace celt
