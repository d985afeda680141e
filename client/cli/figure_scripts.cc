#include "client/cli/figure_scripts.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"

namespace celt::cli {
namespace {

std::string Preamble(const std::string& name, int width, int height) {
  return absl::StrFormat(
      "set terminal pngcairo size %d,%d font 'sans,11' background rgb 'white'\n"
      "set output '%s.png'\n"
      "set datafile separator ','\n"
      "set datafile columnheaders\n"
      "set grid lc rgb '#e8e8e8'\n"
      "set xtics font ',8'\n"
      "unset key\n",
      width, height, name);
}

constexpr char kPoints[] = "with points pt 7 ps 0.2 lc rgb '#1b6ca8'";

/// L/G less its regression on l: the attractor is a needle in the section, and this is the view
/// across it.
std::string Wings(const std::string& file) {
  return absl::StrCat("stats '", file,
                      ".csv' using (column('l')):(column('l_over_g')) name 'A' nooutput\n");
}

constexpr char kAcross[] =
    "using (column('l')):(column('l_over_g') - A_slope*column('l') - A_intercept)";

std::string PanelText(const Panel& panel) {
  const std::string& reference = panel.points.empty() ? panel.manifold : panel.points;
  std::string text = absl::StrCat("set title '", panel.title, "'\n", Wings(reference));
  std::vector<std::string> parts;
  if (!panel.points.empty()) {
    parts.push_back(absl::StrCat("'", panel.points, ".csv' ", kAcross, " ", kPoints));
  }
  for (const char* const side : {"1", "-1"}) {
    if (panel.manifold.empty()) continue;
    const bool right = side[0] == '1';
    parts.push_back(
        absl::StrCat("'", panel.manifold, ".csv' using (column('side') == ", side,
                     " ? column('l') : NaN):(column('l_over_g') - A_slope*column('l') - "
                     "A_intercept) with lines lw 0.7 lc rgb '",
                     right ? "#c0392b" : "#1e8449", "'"));
  }
  absl::StrAppend(&text, "plot ");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    absl::StrAppend(&text, i > 0 ? ", \\\n     " : "", parts[i]);
  }
  return text + "\n";
}

}  // namespace

std::string PanelsScript(const std::string& name, const std::vector<Panel>& panels, int columns) {
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  std::string text = Preamble(name, 480 * columns, 400 * rows);
  absl::StrAppend(&text, "set xlabel 'l'\nset ylabel 'L/G less its regression on l'\n",
                  "set multiplot layout ", rows, ",", columns, "\n");
  for (const Panel& panel : panels) absl::StrAppend(&text, PanelText(panel));
  return text + "unset multiplot\n";
}

std::string LorenzScript(const std::string& name, const std::string& attractor,
                         const std::string& lorenz) {
  return absl::StrCat(
      Preamble(name, 1000, 460), "set multiplot layout 1,2\n",
      "set xlabel 'l'\nset ylabel 'L/G less its regression on l'\n",
      PanelText({.title = "Celtic stone, E = 752", .points = attractor, .manifold = ""}),
      "set title 'Lorenz flow'\nset xlabel 'x'\nset ylabel 'z'\n", "plot '", lorenz,
      ".csv' using (column('x_1')):(column('x_3')) ", kPoints, "\nunset multiplot\n");
}

std::string ExponentScript(const std::string& name, const std::string& sweep) {
  return absl::StrCat(
      Preamble(name, 800, 420),
      "set title 'The largest exponent, with three standard errors'\n"
      "set xlabel 'E'\nset ylabel 'Λ_1 per iterate'\nset yrange [0:*]\n"
      "set format x '%.3f'\nset xtics 0.002\nplot '",
      sweep,
      ".csv' using (column('value_1')):(column('exponent_per_iterate_1')):"
      "(3*column('standard_error_per_iterate_1')) with yerrorbars pt 7 ps 0.4 lc rgb "
      "'#1b6ca8'\n");
}

std::string LmpScript(const std::string& name, const std::vector<Panel>& panels) {
  std::string text = Preamble(name, 480 * static_cast<int>(panels.size()), 420);
  absl::StrAppend(&text, "set logscale x\nset format x '10^{%L}'\nset yrange [0:pi/2]\n",
                  "set xlabel 'distance [standard deviations]'\nset ylabel 'angle [rad]'\n",
                  "set key top left\n", "set multiplot layout 1,", panels.size(), "\n");
  for (const Panel& panel : panels) {
    absl::StrAppend(&text, "set title '", panel.title, "'\nplot '", panel.points,
                    "_largest.csv' using (column('distance')):(column('angle')) with linespoints "
                    "pt 7 ps 0.4 lc rgb '#c0392b' title 'largest', \\\n     '",
                    panel.points, ".csv' using (column('distance')):(column('angle')) ", kPoints,
                    " title 'a sample'\n");
  }
  return text + "unset multiplot\n";
}

std::string BifurcationScript(const std::string& name, const std::string& points) {
  return absl::StrCat(Preamble(name, 1100, 600),
                      "set title 'The attractor, followed upward in E'\n"
                      "set xlabel 'E'\nset ylabel 'l'\nset xrange [747:790]\nplot '",
                      points,
                      ".csv' using (column('energy')):(column('l')) with dots lc rgb '#1b6ca8'\n");
}

}  // namespace celt::cli
