#include "client/cli/cycle_text.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_replace.h"
#include "client/cli/format.h"
#include "client/cli/point.h"
#include "client/cli/text_table.h"

namespace celt::cli {
namespace {

std::string Named(const std::string& text) {
  return absl::StrReplaceAll(
      text, {{"lambda1", "λ1"}, {"lambda2", "λ2"}, {"gamma", "γ"}, {" - ", " − "}});
}

}  // namespace

std::string Decimals(double number, int decimals) {
  std::string text = absl::StrFormat("%.*f", decimals, number);
  if (text.find_first_not_of("-0.") == std::string::npos && text.front() == '-') text.erase(0, 1);
  return text;
}

std::string MultiplierText(const v1::Multiplier& multiplier, int decimals) {
  std::string real = Decimals(multiplier.re(), decimals);
  if (multiplier.im() == 0) return real;
  return absl::StrCat(real, " ± ", Decimals(std::abs(multiplier.im()), decimals), " i");
}

std::string MultipliersText(const google::protobuf::RepeatedPtrField<v1::Multiplier>& multipliers,
                            int decimals) {
  std::string text;
  for (const v1::Multiplier& multiplier : multipliers) {
    if (multiplier.im() < 0) continue;
    absl::StrAppend(&text, text.empty() ? "" : ", ", MultiplierText(multiplier, decimals));
  }
  return text;
}

std::string LorenzTestText(const v1::Cycle& cycle) {
  TextTable table({});
  for (const v1::Inequality& inequality : cycle.lorenz_conditions()) {
    table.Add({inequality.holds() ? "✓" : "✗", Named(inequality.name()),
               Significant(inequality.margin(), 4)});
  }
  return cycle.lorenz_conditions().empty() ? "" : table.Text();
}

std::string LorenzMark(const v1::Cycle& cycle) {
  const auto& conditions = cycle.lorenz_conditions();
  if (conditions.empty()) return "";
  const auto holds = [](const v1::Inequality& inequality) { return inequality.holds(); };
  return std::all_of(conditions.begin(), conditions.end(), holds) ? "✓" : "✗";
}

void AddCycle(const v1::Cycle& cycle, CsvRow& row) {
  if (cycle.points_size() > 0) AddPoint(cycle.points(0), row);
  row.emplace_back("period", absl::StrCat(cycle.period()));
  row.emplace_back("type", cycle.type());
  row.emplace_back("return_time", Shortest(cycle.return_time()));
  for (int i = 0; i < cycle.multipliers_size(); ++i) {
    row.emplace_back(absl::StrCat("multiplier_", i + 1, "_re"),
                     Shortest(cycle.multipliers(i).re()));
    row.emplace_back(absl::StrCat("multiplier_", i + 1, "_im"),
                     Shortest(cycle.multipliers(i).im()));
  }
  row.emplace_back("residual", Shortest(cycle.residual()));
}

std::string SideText(int side) { return side > 0 ? "+" : "−"; }

std::string FateText(const v1::SeparatrixFate& fate) {
  std::string text = fate.end();
  if (fate.end() == "tends to a cycle") absl::StrAppend(&text, " at ", PointText(fate.point()));
  absl::StrAppend(&text, " after ", Grouped(fate.iterates()), " iterates, ");
  if (fate.changes() == 0) return text + "always on its own side";
  return absl::StrCat(text, "last on side ", SideText(fate.side()));
}

std::string AccuracyText(const v1::Accuracy& accuracy) {
  std::string text;
  if (accuracy.has_map_error()) {
    absl::StrAppend(&text, "  map error ", Significant(accuracy.map_error(), 2),
                    ", of its derivative ", Significant(accuracy.jacobian_error(), 2), "\n");
  }
  for (const std::string& warning : accuracy.warnings()) {
    absl::StrAppend(&text, "  warning: ", warning, "\n");
  }
  return text;
}

}  // namespace celt::cli
