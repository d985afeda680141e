#include "tests/bench/table.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "tests/bench/section_bench.h"

namespace celt::bench {
namespace {

constexpr double kMapError = 5e-11;
constexpr double kJacobianError = 3e-10;

/// A time with the error that it was reached at.
struct Cell {
  double micros = 0;  ///< 0: nothing is accurate enough
  double map_error = 0;
  double jacobian_error = 0;
  double tolerance = 0;
};

/// The fastest of a tool's tolerances that is accurate enough, of what was run.
Cell Best(const Collector& runs, const std::string& name, Derivative derivative, int orbits) {
  Cell best;
  for (const Tool& tool : Tools()) {
    const double rate = runs.Rate(SectionBenchName(tool, derivative, orbits));
    if (tool.name != name || rate == 0) continue;
    const Errors& errors = ErrorsOfTool(tool);
    const bool alone = derivative == Derivative::kNone;
    const double map_error = alone ? errors.alone : errors.map;
    if (map_error > kMapError || (!alone && errors.jacobian > kJacobianError)) continue;
    if (best.micros == 0 || 1e6 / rate < best.micros) {
      best = {1e6 / rate, map_error, alone ? 0 : errors.jacobian, tool.tolerance};
    }
  }
  return best;
}

std::string Text(const Cell& cell) {
  if (cell.micros == 0) return "–";
  const std::string errors =
      cell.jacobian_error > 0 ? absl::StrFormat("%.0e, %.0e", cell.map_error, cell.jacobian_error)
                              : absl::StrFormat("%.0e", cell.map_error);
  return absl::StrFormat("%.3g (%s)", cell.micros, errors);
}

std::string Row(const std::string& title, const Cell& map, const Cell& one, const Cell& many) {
  return absl::StrCat("| ", title, " | ", Text(map), " | ", Text(one), " | ", Text(many), " |\n");
}

std::string Ratio(double numerator, double denominator) {
  return denominator > 0 ? absl::StrFormat("%.3g", numerator / denominator) : "–";
}

/// The tools that are compared with, by name and as the table calls them.
constexpr std::pair<const char*, const char*> kOthers[] = {
    {"cvode", "SUNDIALS CVODE 6.4, Adams"},
    {"arkode", "SUNDIALS ARKODE, 8(7)"},
    {"odeint", "Boost.odeint 1.74, RKF7(8)"},
    {"odeint-fast", "Boost.odeint, celt's equations"}};

/// How many times longer than ours the others take.
std::string Ratios(const Collector& runs) {
  const auto micros = [&runs](const char* name, Derivative derivative, int orbits) {
    return Best(runs, name, derivative, orbits).micros;
  };
  const double alone = micros("fast", Derivative::kNone, 64);
  const double one = micros("fast", Derivative::kJacobian, 1);
  const double many = micros("fast", Derivative::kJacobian, 64);
  std::string text =
      "\n| takes so many times as long as celt | map alone, by celt of 64 orbits | one orbit with "
      "tangents | with tangents, by celt of 64 orbits |\n|---|---|---|---|\n";
  for (const auto& [name, title] : kOthers) {
    const double other = micros(name, Derivative::kJacobian, 1);
    absl::StrAppend(&text, "| ", title, " | ", Ratio(micros(name, Derivative::kNone, 1), alone),
                    " | ", Ratio(other, one), " | ", Ratio(other, many), " |\n");
  }
  return text;
}

std::string Service(const Collector& runs) {
  const double bare = runs.Rate("spectrum/bare/process_time");
  const double job = runs.Rate("spectrum/job/process_time");
  const double one = runs.Rate("cores/real_time/threads:1");
  const double two = runs.Rate("cores/real_time/threads:2");
  const double chart = runs.Rate("chart");
  std::string text;
  if (bare > 0 && job > 0) {
    absl::StrAppendFormat(&text,
                          "\nA job of 10⁵ iterates costs %.1f %% more than its engine alone.",
                          100 * (bare / job - 1));
  }
  if (one > 0 && two > 0)
    absl::StrAppendFormat(&text, " Two cores do %.2f times as much as one.", two / one);
  if (chart > 0) {
    absl::StrAppendFormat(
        &text, " A chart of 100 × 100 nodes with 2,000 iterates each takes %.0f s of one core.",
        1e4 / chart);
  }
  return text.empty() ? text : text + "\n";
}

}  // namespace

void Collector::ReportRuns(const std::vector<Run>& runs) {
  ConsoleReporter::ReportRuns(runs);
  for (const Run& run : runs) {
    const auto rate = run.counters.find("items_per_second");
    if (run.run_type != Run::RT_Iteration || rate == run.counters.end()) continue;
    rates_[run.run_name.str()].push_back(rate->second);
  }
}

double Collector::Rate(const std::string& name) const {
  const auto found = rates_.find(name);
  if (found == rates_.end()) return 0;
  std::vector<double> rates = found->second;
  const auto middle = rates.begin() + static_cast<std::ptrdiff_t>(rates.size() / 2);
  std::nth_element(rates.begin(), middle, rates.end());
  return *middle;
}

std::string Table(const Collector& runs) {
  std::string text =
      "| tool | map alone: µs (error) | one orbit with three tangents: µs (error, of Jacobian) | "
      "many "
      "orbits with three tangents |\n|---|---|---|---|\n";
  const auto best = [&runs](const char* name, Derivative derivative, int orbits) {
    return Best(runs, name, derivative, orbits);
  };
  for (const auto& [name, title] : kOthers) {
    text += Row(title, best(name, Derivative::kNone, 1), best(name, Derivative::kJacobian, 1), {});
  }
  text += Row("celt, one orbit", best("fast", Derivative::kNone, 1),
              best("fast", Derivative::kJacobian, 1), {});
  for (const int orbits : {8, 64, 4096}) {
    text += Row(absl::StrCat("celt, ", orbits, " orbits"), best("fast", Derivative::kNone, orbits),
                {}, best("fast", Derivative::kJacobian, orbits));
  }
  return text + Ratios(runs) + Service(runs);
}

}  // namespace celt::bench
