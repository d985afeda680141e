#include "client/cli/hyperbolicity_table.h"

#include <algorithm>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "client/cli/cycle_text.h"
#include "client/cli/format.h"
#include "client/cli/point.h"
#include "client/cli/text_table.h"

namespace celt::cli {
namespace {

constexpr int kDigits = 3;

using Doubles = google::protobuf::RepeatedField<double>;

std::string Mark(const std::string& outcome) {
  if (outcome == "passed") return "✓";
  return outcome == "failed" ? "✗" : "?";
}

/// What each test asks, in the units of its margin.
std::string Question(const std::string& name) {
  if (name == "exponents") return "the paper's conditions on the exponents [standard errors]";
  if (name == "settled") return "E^ss known to 1e-6 [rad]";
  if (name == "angle") return "E^ss and E^cu stay apart [decades]";
  if (name == "lmp") return "E^ss is continuous [rad]";
  return "volume on E^cu grows [per iterate]";
}

std::string Number(bool known, double number) { return known ? Significant(number, kDigits) : ""; }

std::string Tests(const v1::HyperbolicityResult& result) {
  TextTable table({"", "test", "margin", ""});
  for (const v1::HyperbolicityTest& test : result.tests()) {
    table.Add({Mark(test.outcome()), test.name(), Number(test.has_margin(), test.margin()),
               Question(test.name())});
  }
  std::string text = table.Text();
  for (const v1::HyperbolicityTest& test : result.tests()) {
    absl::StrAppend(&text, "    ", test.name(), ": ", test.why(), "\n");
  }
  return text;
}

std::string Exponents(const v1::HyperbolicityResult& result) {
  std::vector<std::string> parts;
  for (int i = 0; i < result.exponents_per_iterate_size(); ++i) {
    const bool known = i < result.standard_error_per_iterate_size();
    const double error = known ? result.standard_error_per_iterate(i) : 0;
    parts.push_back(
        absl::StrCat("Λ", i + 1, " ", WithError(result.exponents_per_iterate(i), error)));
  }
  return absl::StrCat("  ", absl::StrJoin(parts, ", "), " per iterate\n");
}

std::string List(const Doubles& numbers) {
  const auto write = [](std::string* text, double x) {
    absl::StrAppend(text, Significant(x, kDigits));
  };
  return absl::StrJoin(numbers, ", ", write);
}

std::string Angles(const v1::HyperbolicityResult& result) {
  TextTable table({});
  table.Add({"minimum angle [rad]", Significant(result.minimum_angle(), kDigits)});
  table.Add({"at", PointText(result.minimum_point())});
  table.Add({"over 1/8, 1/4, 1/2 and all of the orbit", List(result.minimum_by_length())});
  for (const v1::AngleQuantile& quantile : result.quantiles()) {
    if (quantile.fraction() != 0.5 && quantile.fraction() != 0.01) continue;
    table.Add({absl::StrCat("quantile ", Shortest(quantile.fraction())),
               Significant(quantile.angle(), kDigits)});
  }
  if (result.has_tail_index()) {
    table.Add({"tail index", Significant(result.tail_index(), kDigits)});
  }
  if (result.has_promised_minimum()) {
    table.Add({"promised for an orbit 100 times longer",
               Significant(result.promised_minimum(), kDigits)});
  }
  return table.Text();
}

std::string Lmp(const v1::HyperbolicityResult& result) {
  TextTable table({"distance below", "pairs", "largest angle [rad]"});
  for (const v1::LmpBin& bin : result.lmp_graph()) {
    if (bin.pairs() == 0 || bin.to() > 2) continue;
    table.Add({Significant(bin.to(), kDigits), Grouped(bin.pairs()),
               Significant(bin.largest_angle(), kDigits)});
  }
  return table.Text();
}

bool ConditionsHold(const v1::HyperbolicityResult& result) {
  const auto& conditions = result.conditions();
  return !conditions.empty() &&
         std::all_of(conditions.begin(), conditions.end(),
                     [](const v1::Condition& condition) { return condition.holds(); });
}

std::string Names(const v1::HyperbolicityResult& result, const std::string& outcome) {
  std::vector<std::string> names;
  for (const v1::HyperbolicityTest& test : result.tests()) {
    if (test.outcome() == outcome) names.push_back(test.name());
  }
  return absl::StrJoin(names, ", ");
}

std::string Verdict(const v1::HyperbolicityResult& result) {
  switch (result.verdict()) {
    case v1::PSEUDO_HYPERBOLIC:
      return "PSEUDO-HYPERBOLIC: every test was passed.\n";
    case v1::TANGENCIES:
      return absl::StrCat(
          "TANGENCIES: E^ss meets E^cu or is not continuous (failed: ", Names(result, "failed"),
          ").\n",
          ConditionsHold(result)
              ? "The paper's conditions on the exponents hold, and yet the attractor is not\n"
                "pseudo-hyperbolic: those conditions are necessary, not sufficient.\n"
              : "");
    default: {
      const std::string failed = Names(result, "failed");
      const std::string open = Names(result, "open");
      return absl::StrCat(
          "UNDECIDED: neither every test passed nor a tangency of a chaotic attractor"
          " seen",
          failed.empty() ? "" : absl::StrCat("; failed: ", failed),
          open.empty() ? "" : absl::StrCat("; open: ", open), ".\n");
    }
  }
}

}  // namespace

std::string HyperbolicityTable(const v1::JobSpec& spec, const v1::HyperbolicityResult& result) {
  return absl::StrCat("Pseudo-hyperbolicity of ", SystemTitle(spec.system()), "\n",
                      Grouped(result.samples()),
                      " samples along one orbit; angles and distances in whitened coordinates\n\n",
                      Exponents(result), "\n", Angles(result),
                      "\nPairs of points of the orbit (LMP graph):\n", Lmp(result), "\nTests:\n",
                      Tests(result), "\n", Verdict(result), AccuracyText(result.accuracy()));
}

}  // namespace celt::cli
