#include "client/cli/lyapunov_table.h"

#include <cmath>
#include <optional>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "client/cli/format.h"
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

std::string Conditions(const v1::LyapunovResult& result) {
  TextTable table({});
  for (const v1::Condition& condition : result.conditions()) {
    table.Add({condition.holds() ? "✓" : "✗",
               absl::StrReplaceAll(condition.name(), {{"lambda", "Λ"}}), Margin(condition)});
  }
  return table.Text();
}

}  // namespace

std::string LyapunovTable(const v1::JobSpec& spec, const v1::LyapunovResult& result) {
  std::string text = absl::StrCat("Lyapunov spectrum of ", SystemTitle(spec.system()), "\n",
                                  Grouped(result.iterates()), " iterates, ", result.orbits(),
                                  result.orbits() == 1 ? " orbit" : " orbits", "\n\n");
  absl::StrAppend(&text, Exponents(result), "\n", Measures(result));
  if (result.conditions_size() == 0) return text;
  absl::StrAppend(&text, "\nNecessary for pseudo-hyperbolicity, with margins:\n",
                  Conditions(result));
  return text;
}

}  // namespace celt::cli
