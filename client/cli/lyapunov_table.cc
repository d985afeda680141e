#include "client/cli/lyapunov_table.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_replace.h"
#include "client/cli/format.h"
#include "client/cli/regime.h"
#include "client/cli/text_table.h"

namespace celt::cli {
namespace {

std::optional<double> At(const google::protobuf::RepeatedField<double>& values, int index) {
  if (index < values.size()) return values[index];
  return std::nullopt;
}

std::string Estimate(const google::protobuf::RepeatedField<double>& values,
                     const google::protobuf::RepeatedField<double>& errors, int index) {
  const auto value = At(values, index);
  return value ? WithError(*value, At(errors, index)) : "";
}

std::string Exponents(const v1::LyapunovResult& result) {
  TextTable table({"", "per iterate", "per unit of time"});
  for (int i = 0; i < result.exponents_per_iterate_size(); ++i) {
    table.Add({absl::StrCat("Λ", i + 1),
               Estimate(result.exponents_per_iterate(), result.standard_error_per_iterate(), i),
               Estimate(result.exponents_per_time(), result.standard_error_per_time(), i)});
  }
  std::optional<double> error;
  if (result.has_standard_error_sum_per_iterate()) error = result.standard_error_sum_per_iterate();
  if (result.has_sum_per_iterate()) {
    table.Add({"sum", WithError(result.sum_per_iterate(), error), ""});
  }
  return table.Text();
}

/// An error, of which the order of magnitude is what counts.
std::string Error(double error) { return error > 0 ? absl::StrFormat("%.1e", error) : "0"; }

double Largest(const google::protobuf::RepeatedField<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

std::string Measures(const v1::LyapunovResult& result) {
  std::optional<double> error;
  if (result.has_standard_error_return_time()) error = result.standard_error_return_time();
  TextTable table({});
  if (result.has_mean_return_time()) {
    table.Add({"mean return time", WithError(result.mean_return_time(), error)});
  }
  if (result.has_kaplan_yorke_dimension()) {
    table.Add({"Kaplan–Yorke dimension", Significant(result.kaplan_yorke_dimension(), 5)});
  }
  if (result.regime() != v1::REGIME_UNSPECIFIED) {
    table.Add({"regime", RegimeName(result.regime())});
  }
  if (result.has_accuracy()) {
    table.Add({"error of the map", Error(result.accuracy().map_error())});
    table.Add({"  of its Jacobian", Error(result.accuracy().jacobian_error())});
    table.Add({"  in the exponents", Error(Largest(result.map_error_per_iterate()))});
  }
  return table.Text();
}

/// Beyond a thousand standard errors the number says no more than that it is large.
std::string Margin(const v1::Condition& condition) {
  constexpr double kLarge = 1000;
  if (!condition.has_margin()) return "margin unknown";
  const double margin = condition.margin();
  if (margin >= kLarge) return "> 1000 σ";
  if (margin <= -kLarge) return "< -1000 σ";
  return absl::StrCat(std::abs(margin) < 10 ? Significant(margin, 2) : Significant(margin, 3),
                      " σ");
}

/// "?" where the estimate's own error does not tell.
std::string Mark(const v1::Condition& condition) {
  constexpr double kSure = 3;
  if (!condition.has_margin() || std::abs(condition.margin()) < kSure) return "?";
  return condition.holds() ? "✓" : "✗";
}

std::string Warnings(const v1::LyapunovResult& result) {
  std::string text;
  for (const std::string& warning : result.accuracy().warnings()) {
    absl::StrAppend(&text, "\nwarning: ", absl::StrReplaceAll(warning, {{"lambda", "Λ"}}), "\n");
  }
  return text;
}

std::string Conditions(const v1::LyapunovResult& result) {
  TextTable table({});
  for (const v1::Condition& condition : result.conditions()) {
    table.Add({Mark(condition), absl::StrReplaceAll(condition.name(), {{"lambda", "Λ"}}),
               Margin(condition)});
  }
  return table.Text();
}

}  // namespace

std::string LyapunovTable(const v1::JobSpec& spec, const v1::LyapunovResult& result) {
  std::string text = absl::StrCat("Lyapunov spectrum of ", SystemTitle(spec.system()), "\n",
                                  Grouped(result.iterates()), " iterates, ", result.orbits(),
                                  result.orbits() == 1 ? " orbit" : " orbits", "\n\n");
  absl::StrAppend(&text, Exponents(result), "\n", Measures(result));
  if (result.conditions_size() > 0) {
    absl::StrAppend(&text, "\nNecessary for pseudo-hyperbolicity, with margins:\n",
                    Conditions(result));
  }
  absl::StrAppend(&text, Warnings(result));
  return text;
}

}  // namespace celt::cli
