#include "client/cli/point.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "client/cli/format.h"

namespace celt::cli {
namespace {

std::vector<std::string> Numbered(const std::string& stem, int count) {
  std::vector<std::string> names;
  for (int i = 1; i <= count; ++i) names.push_back(absl::StrCat(stem, i));
  return names;
}

}  // namespace

std::vector<std::string> CoordinateColumns(const v1::Point& point) {
  if (point.has_l()) return {"l", "l_over_g", "h_over_g"};
  return Numbered("x_", point.x_size());
}

std::vector<std::string> CoordinateTitles(const v1::Point& point) {
  if (point.has_l()) return {"l", "L/G", "H/G"};
  return Numbered("x", point.x_size());
}

std::vector<double> Coordinates(const v1::Point& point) {
  if (point.has_l()) return {point.l(), point.l_over_g(), point.h_over_g()};
  return {point.x().begin(), point.x().end()};
}

void AddPoint(const v1::Point& point, CsvRow& row) {
  const std::vector<std::string> names = CoordinateColumns(point);
  const std::vector<double> values = Coordinates(point);
  for (std::size_t i = 0; i < names.size(); ++i) row.emplace_back(names[i], Shortest(values[i]));
}

std::string PointText(const v1::Point& point) {
  const auto write = [](std::string* text, double x) { absl::StrAppendFormat(text, "%.6f", x); };
  return absl::StrCat("(", absl::StrJoin(Coordinates(point), ", ", write), ")");
}

std::string Column(double number, int width, int decimals) {
  if (width == 0) return absl::StrFormat("%.*f", decimals, number);
  return absl::StrFormat(" %*.*f", width - 1, decimals, number);
}

}  // namespace celt::cli
