#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "CLI/App.hpp"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"

namespace celt::cli {

/// The options of every computing command that say what is computed on: the system and its
/// parameters, the section, the frame, the integrator.
class SystemOptions {
 public:
  /// Adds the options to a command; this object must outlive the parsing.
  void AddTo(CLI::App& app);

  /// Writes what was given into the specification, and nothing else. INVALID_ARGUMENT names the
  /// option: one of the stone's with another system, or a parameter given twice.
  absl::Status Fill(v1::JobSpec& spec) const;

 private:
  void AddStone(CLI::App& app);
  void AddSystem(CLI::App& app);
  void AddNumerics(CLI::App& app);
  /// A parameter of the stone with the option that gave it.
  struct StoneValue {
    std::string option;
    std::string parameter;
    double value = 0;
  };
  std::vector<StoneValue> StoneValues() const;
  void FillNumerics(v1::JobSpec& spec) const;

  std::string system_;
  std::map<std::string, double> set_;
  /// The stone's options with one number, by the parameter's name.
  std::map<std::string, std::optional<double>> numbers_;
  std::optional<std::vector<double>> inertia_;
  std::optional<std::vector<double>> radii_;
  std::optional<int> frame_;
  std::optional<double> tolerance_;
  std::optional<int> engine_;
};

/// Whether the specification is about the Celtic stone, which it is by default.
bool IsStone(const v1::JobSpec& spec);

/// A point given on the command line: l, L/G, H/G of the stone, x[] of the others. `option` is
/// named when the stone's point has not three coordinates.
absl::StatusOr<v1::Point> MakePoint(const v1::JobSpec& spec, const std::vector<double>& coordinates,
                                    const std::string& option);

}  // namespace celt::cli
