#include "client/cli/fixed_point_table.h"

#include <cmath>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/cli/cycle_text.h"
#include "client/cli/format.h"
#include "client/cli/point.h"
#include "client/cli/text_table.h"

namespace celt::cli {
namespace {

constexpr int kPointDecimals = 12;
constexpr int kMultiplierDecimals = 10;

std::string Kind(int period) {
  return period == 1 ? "Fixed point" : absl::StrCat("Cycle of period ", period);
}

std::string Points(const v1::Cycle& cycle) {
  if (cycle.points().empty()) return "";
  std::vector<std::string> header = CoordinateTitles(cycle.points(0));
  header.insert(header.begin(), "");
  TextTable table(header);
  int number = 0;
  for (const v1::Point& point : cycle.points()) {
    std::vector<std::string> row = {absl::StrCat(++number)};
    for (const double x : Coordinates(point)) row.push_back(Decimals(x, kPointDecimals));
    table.Add(row);
  }
  return table.Text();
}

std::string Multipliers(const v1::Cycle& cycle) {
  TextTable table({"multipliers", "modulus"});
  for (const v1::Multiplier& multiplier : cycle.multipliers()) {
    if (multiplier.im() < 0) continue;
    table.Add({MultiplierText(multiplier, kMultiplierDecimals),
               Decimals(std::hypot(multiplier.re(), multiplier.im()), kMultiplierDecimals)});
  }
  return table.Text();
}

std::string Measures(const v1::Cycle& cycle) {
  TextTable table({});
  table.Add({"return time", Decimals(cycle.return_time(), kPointDecimals)});
  table.Add({"residual", Significant(cycle.residual(), 2)});
  table.Add({"last correction", Significant(cycle.correction(), 2)});
  return table.Text();
}

/// What a search knows of its cycle number `i`.
std::string Relations(const v1::FixedPointResult& result, int i) {
  if (i >= result.hits_size() || i >= result.twins_size() || i >= result.mirrors_size()) return "";
  std::vector<std::string> parts;
  const std::int64_t hits = result.hits(i);
  parts.push_back(hits == 0   ? "no start led here"
                  : hits == 1 ? "1 start led here"
                              : absl::StrCat(Grouped(hits), " starts led here"));
  if (result.twins(i) > 0) {
    parts.push_back(absl::StrCat(result.twins(i), result.twins(i) == 1 ? " twin" : " twins"));
  }
  const int mirror = result.mirrors(i);
  if (mirror == i) parts.push_back("its own mirror image");
  if (mirror >= 0 && mirror != i) parts.push_back(absl::StrCat("mirror image of ", mirror + 1));
  return absl::StrCat("  ", absl::StrJoin(parts, ", "), "\n");
}

std::string Block(const v1::FixedPointResult& result, int i) {
  const v1::Cycle& cycle = result.cycles(i);
  const std::string mark = LorenzMark(cycle);
  return absl::StrCat(
      "\n", i + 1, ". ", cycle.type(), ", return time ", Decimals(cycle.return_time(), 10),
      mark == "✓" ? ", passes the paper's test" : "", "\n", Points(cycle), "  multipliers  ",
      MultipliersText(cycle.multipliers(), kMultiplierDecimals), "\n", Relations(result, i));
}

std::string TallyText(const v1::SearchTally& tally) {
  std::vector<std::string> parts;
  const auto add = [&parts](std::int64_t count, const char* what) {
    if (count > 0) parts.push_back(absl::StrCat(Grouped(count), " ", what));
  };
  add(tally.found(), "found a cycle");
  add(tally.shorter(), "one of a shorter period");
  add(tally.no_convergence(), "did not converge");
  add(tally.left_domain(), "left the domain on the way");
  add(tally.singular(), "met a singular derivative");
  add(tally.outside(), "lay outside the domain");
  return absl::StrCat("Of ", Grouped(tally.starts()), " starts ", absl::StrJoin(parts, ", "),
                      ".\n");
}

std::string SearchTable(const v1::JobSpec& spec, const v1::FixedPointResult& result) {
  const int period = spec.fixed_point().period();
  std::string text = absl::StrCat(
      period > 1 ? absl::StrCat("Cycles of period ", period) : "Fixed points", " of ",
      SystemTitle(spec.system()), ": ",
      result.cycles().empty() ? "none found" : absl::StrCat(result.cycles_size(), " found"), "\n");
  for (int i = 0; i < result.cycles_size(); ++i) absl::StrAppend(&text, Block(result, i));
  return absl::StrCat(text, "\n", TallyText(result.tally()), AccuracyText(result.accuracy()));
}

}  // namespace

std::string FixedPointTable(const v1::JobSpec& spec, const v1::FixedPointResult& result) {
  if (result.has_tally() || result.cycles().empty()) return SearchTable(spec, result);
  const v1::Cycle& cycle = result.cycles(0);
  std::string text = absl::StrCat(Kind(cycle.period()), " of ", SystemTitle(spec.system()), ": ",
                                  cycle.type(), "\n\n", Points(cycle), "\n", Multipliers(cycle),
                                  "\n", Measures(cycle), AccuracyText(result.accuracy()));
  if (cycle.lorenz_conditions().empty()) return text;
  absl::StrAppend(&text, "\nThe paper's test for a discrete Lorenz attractor, with margins: ",
                  LorenzMark(cycle), "\n", LorenzTestText(cycle));
  return text;
}

}  // namespace celt::cli
