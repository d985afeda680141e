#include "client/cli/continuation_table.h"

#include <algorithm>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "client/cli/cycle_text.h"
#include "client/cli/format.h"
#include "client/cli/point.h"
#include "client/cli/text_table.h"

namespace celt::cli {
namespace {

constexpr int kValueDecimals = 10;
constexpr int kMultiplierDecimals = 6;

/// One for a fold's, a pair's one, of a pair that meets its one value.
std::string Critical(const v1::Bifurcation& bifurcation) {
  if (bifurcation.critical().empty()) return "";
  return absl::StrCat(bifurcation.type() == v1::MULTIPLIERS_MEET ? "at " : "multiplier ",
                      MultiplierText(bifurcation.critical(0), kMultiplierDecimals));
}

std::string Angle(const v1::Bifurcation& bifurcation) {
  if (!bifurcation.has_angle()) return "";
  std::string text = absl::StrCat("angle ", Decimals(bifurcation.angle(), kMultiplierDecimals));
  if (!bifurcation.resonance().empty()) {
    absl::StrAppend(&text, ", strong resonance ", bifurcation.resonance());
  }
  return text;
}

std::string NormalForm(const v1::Bifurcation& bifurcation) {
  if (!bifurcation.has_criticality()) return "";
  if (!bifurcation.has_coefficient()) return bifurcation.criticality() + " criticality";
  return absl::StrCat(bifurcation.criticality(), ", coefficient ",
                      WithError(bifurcation.coefficient(), bifurcation.coefficient_error()));
}

std::string Details(const v1::Bifurcation& bifurcation) {
  std::vector<std::string> parts = {Critical(bifurcation), Angle(bifurcation),
                                    NormalForm(bifurcation)};
  parts.erase(std::remove(parts.begin(), parts.end(), ""), parts.end());
  return absl::StrJoin(parts, ", ");
}

std::string Value(const v1::Bifurcation& bifurcation) {
  return absl::StrCat(Decimals(bifurcation.value(), kValueDecimals), " ± ",
                      Significant(bifurcation.value_error(), 1));
}

std::string Bifurcations(const std::string& parameter, const v1::ContinuationResult& result) {
  if (result.bifurcations().empty()) return "no bifurcation met\n";
  TextTable table({"bifurcation", parameter, "branch"});
  for (const v1::Bifurcation& bifurcation : result.bifurcations()) {
    table.Add({v1::BifurcationType_Name(bifurcation.type()), Value(bifurcation),
               absl::StrCat(bifurcation.branch()), Details(bifurcation)});
  }
  return table.Text();
}

std::string Branches(const std::string& parameter, const v1::ContinuationResult& result) {
  TextTable table({"branch", "period", "points", absl::StrCat(parameter, " from"), "to", "end"});
  for (const v1::BranchSummary& branch : result.branches()) {
    const std::string end = branch.message().empty()
                                ? branch.end()
                                : absl::StrCat(branch.end(), ": ", branch.message());
    table.Add({absl::StrCat(branch.branch()), absl::StrCat(branch.period()),
               absl::StrCat(branch.points()), Significant(branch.from(), 10),
               Significant(branch.to(), 10), end});
  }
  return table.Text();
}

std::string PointLine(const v1::BranchPoint& point) {
  return absl::StrFormat("%8d %17s  %-18s %s\n", point.branch(),
                         Decimals(point.value(), kValueDecimals), point.cycle().type(),
                         MultipliersText(point.cycle().multipliers(), kMultiplierDecimals));
}

}  // namespace

std::string ContinuationLine(const v1::Record& record) {
  std::string text;
  if (record.sequence() == 1) {
    text = absl::StrFormat("%8s %17s  %-18s %s\n", "branch", "parameter", "type", "multipliers");
  }
  const v1::ContinuationRecord& piece = record.continuation();
  if (piece.has_point()) return text + PointLine(piece.point());
  const v1::Bifurcation& bifurcation = piece.bifurcation();
  return absl::StrCat(text,
                      absl::StrFormat("%8d %17s  ", bifurcation.branch(),
                                      Decimals(bifurcation.value(), kValueDecimals)),
                      v1::BifurcationType_Name(bifurcation.type()), " ", Details(bifurcation),
                      "\n");
}

std::string ContinuationBrief(const v1::ContinuationResult& result) {
  std::vector<std::string> parts;
  for (const v1::Bifurcation& bifurcation : result.bifurcations()) {
    parts.push_back(absl::StrCat(v1::BifurcationType_Name(bifurcation.type()), " at ",
                                 Decimals(bifurcation.value(), kValueDecimals)));
  }
  for (const v1::BranchSummary& branch : result.branches()) parts.push_back(branch.end());
  return absl::StrJoin(parts, "; ");
}

std::string ContinuationTable(const v1::JobSpec& spec, const v1::ContinuationResult& result) {
  const v1::ContinuationSpec& asked = spec.continuation();
  const std::string parameter = asked.parameter().empty() ? "parameter" : asked.parameter();
  const std::string what =
      asked.period() > 1 ? absl::StrCat("cycles of period ", asked.period()) : "fixed points";
  return absl::StrCat("\nBranch of ", what, " of ", spec.system().name(), ", ", parameter, " from ",
                      Shortest(asked.from()), " to ", Shortest(asked.to()), "\n\n",
                      Bifurcations(parameter, result), "\n", Branches(parameter, result), "\n",
                      AccuracyText(result.accuracy()));
}

}  // namespace celt::cli
