#include "client/cli/figures.h"

#include <algorithm>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/cli/csv.h"
#include "client/cli/figure_data.h"
#include "client/cli/figure_scripts.h"
#include "client/cli/format.h"

namespace celt::cli {
namespace {

v1::JobSpec At(double energy) {
  v1::JobSpec spec;
  (*spec.mutable_system()->mutable_parameters())["energy"] = energy;
  return spec;
}

/// Points of the attractor that is reached from `start` (by default, from the known start).
absl::StatusOr<v1::Point> Attractor(FigureData& data, const std::string& name, double energy,
                                    const v1::Point& start, std::int64_t transient,
                                    std::int64_t iterates) {
  v1::JobSpec spec = At(energy);
  v1::SectionSpec& section = *spec.mutable_section();
  if (start.has_l()) *section.mutable_start() = start;
  section.set_transient(transient);
  section.set_iterates(iterates);
  const auto result = data.Records(name, spec);
  if (!result.ok()) return result.status();
  return result->section().last();
}

absl::Status UnstableManifold(FigureData& data, const std::string& name, double energy,
                              double length) {
  v1::JobSpec spec = At(energy);
  spec.mutable_manifold()->set_length(length);
  return data.Records(name, spec).status();
}

constexpr std::int64_t kTransient = 5000;
constexpr std::int64_t kPoints = 10'000;

absl::Status BesideLorenz(FigureData& data) {
  const auto stone = Attractor(data, "attractor_752", 752, {}, 1000, kPoints);
  if (!stone.ok()) return stone.status();
  v1::JobSpec spec;
  spec.mutable_system()->set_name("lorenz");
  (*spec.mutable_system()->mutable_parameters())["step"] = 0.02;
  spec.mutable_section()->set_transient(1000);
  spec.mutable_section()->set_iterates(kPoints);
  const auto lorenz = data.Records("lorenz", spec);
  if (!lorenz.ok()) return lorenz.status();
  return data.Plot("fig3", LorenzScript("fig3", "attractor_752", "lorenz"));
}

absl::Status ExponentGraph(FigureData& data) {
  v1::JobSpec spec;
  v1::Axis& axis = *spec.mutable_sweep()->add_axes();
  axis.set_parameter("energy");
  axis.set_from(752);
  axis.set_to(752.01);
  axis.set_nodes(101);
  spec.mutable_sweep()->mutable_lyapunov()->set_iterates(20'000);
  spec.mutable_sweep()->mutable_lyapunov()->set_transient(200);
  const auto result = data.Records("exponents", spec);
  if (!result.ok()) return result.status();
  return data.Plot("fig4", ExponentScript("fig4", "exponents"));
}

absl::Status StagesOfBirth(FigureData& data) {
  const auto first = Attractor(data, "birth_747", 747, {}, 0, 300);
  if (!first.ok()) return first.status();
  struct Stage {
    const char* name;
    double energy;
    double length;
  };
  for (const Stage& stage : {Stage{"birth_748_4", 748.4, 1}, Stage{"birth_748_4395", 748.4395, 1},
                             Stage{"birth_748_5", 748.5, 1}, Stage{"birth_750", 750, 3}}) {
    absl::Status status = UnstableManifold(data, stage.name, stage.energy, stage.length);
    if (!status.ok()) return status;
  }
  const auto last = Attractor(data, "attractor_750", 750, {}, kTransient, kPoints);
  if (!last.ok()) return last.status();
  return data.Plot("fig5", PanelsScript("fig5",
                                        {{"a) E = 747: iterates", "birth_747", ""},
                                         {"b) E = 748.4: W^u(O)", "", "birth_748_4"},
                                         {"c) E = 748.4395: W^u(O)", "", "birth_748_4395"},
                                         {"d) E = 748.5: W^u(O)", "", "birth_748_5"},
                                         {"e) E = 750: W^u(O)", "", "birth_750"},
                                         {"f) E = 750: attractor", "attractor_750", ""}},
                                        3));
}

absl::Status ManifoldAndAttractor(FigureData& data) {
  absl::Status status = UnstableManifold(data, "manifold_752", 752, 4);
  if (!status.ok()) return status;
  return data.Plot("fig6", PanelsScript("fig6",
                                        {{"a) W^u(O*), E = 752", "", "manifold_752"},
                                         {"b) attractor, E = 752", "attractor_752", ""}},
                                        2));
}

/// From an arbitrary start one falls on other attractors: 780 is reached by following from below.
absl::Status StagesOfDestruction(FigureData& data) {
  std::vector<Panel> panels;
  for (const double energy : {754.0, 755.0, 765.0, 770.0, 775.0}) {
    const std::string name = absl::StrFormat("attractor_%g", energy);
    const auto points = Attractor(data, name, energy, {}, kTransient, kPoints);
    if (!points.ok()) return points.status();
    panels.push_back({absl::StrFormat("E = %g", energy), name, ""});
  }
  v1::Point at;
  for (const double energy : {774.0, 776.0, 778.0, 780.0}) {
    const auto next = Attractor(data, "attractor_780", energy, at, kTransient, kPoints);
    if (!next.ok()) return next.status();
    at = *next;
  }
  panels.push_back({"E = 780", "attractor_780", ""});
  return data.Plot("fig7", PanelsScript("fig7", panels, 3));
}

absl::Status LmpPairs(FigureData& data, const std::string& name, v1::JobSpec spec) {
  spec.mutable_hyperbolicity()->set_iterates(40'000);
  const auto result = data.Records("angles_" + name, spec);
  if (!result.ok()) return result.status();
  std::string sample = CsvLine({"distance", "angle"});
  std::string largest = sample;
  for (const v1::LmpBin& bin : result->hyperbolicity().lmp_graph()) {
    for (const v1::LmpPair& pair : bin.sample()) {
      absl::StrAppend(&sample, CsvLine({Shortest(pair.distance()), Shortest(pair.angle())}));
    }
    if (!bin.has_largest_angle()) continue;
    absl::StrAppend(&largest, CsvLine({Shortest(bin.to()), Shortest(bin.largest_angle())}));
  }
  absl::Status written = data.Write("lmp_" + name + ".csv", sample);
  return written.ok() ? data.Write("lmp_" + name + "_largest.csv", largest) : written;
}

absl::Status LmpGraphs(FigureData& data) {
  v1::JobSpec henon;
  henon.mutable_system()->set_name("henon3d");
  (*henon.mutable_system()->mutable_parameters())["m2"] = 0.815;
  for (const absl::Status& status :
       {LmpPairs(data, "henon", henon), LmpPairs(data, "stone", At(752))}) {
    if (!status.ok()) return status;
  }
  return data.Plot("lmp", LmpScript("lmp", {{"Hénon map, m2 = 0.815", "lmp_henon", ""},
                                            {"Celtic stone, E = 752", "lmp_stone", ""}}));
}

absl::Status BifurcationDiagram(FigureData& data) {
  constexpr double kFrom = 747;
  constexpr double kTo = 790;
  constexpr int kNodes = 345;  // an eighth apart
  v1::Point at;
  std::string text = CsvLine({"energy", "l"});
  for (int i = 0; i < kNodes; ++i) {
    const double energy = kFrom + (kTo - kFrom) * i / (kNodes - 1);
    v1::JobSpec spec = At(energy);
    if (at.has_l()) *spec.mutable_section()->mutable_start() = at;
    spec.mutable_section()->set_transient(500);
    spec.mutable_section()->set_iterates(400);
    const auto add = [&](const v1::Record& record) {
      absl::StrAppend(&text, CsvLine({Shortest(energy), Shortest(record.section().point().l())}));
    };
    const auto result = data.Run(absl::StrFormat("E = %g", energy), spec, add);
    if (!result.ok()) return result.status();
    at = result->section().last();
  }
  const absl::Status written = data.Write("bifurcation.csv", text);
  return written.ok() ? data.Plot("bifurcation", BifurcationScript("bifurcation", "bifurcation"))
                      : written;
}

}  // namespace

ExitCode MakeFigures(const Session& session, const std::string& folder) {
  FigureData data(session.client(), session.terminal(), session.interrupt(), folder);
  absl::Status status = data.Open();
  for (const auto make : {BesideLorenz, ExponentGraph, StagesOfBirth, ManifoldAndAttractor,
                          StagesOfDestruction, LmpGraphs, BifurcationDiagram}) {
    if (status.ok()) status = make(data);
  }
  session.terminal().ClearProgress();
  if (status.ok()) return kDone;
  session.terminal().Say(std::string(status.message()));
  return absl::IsCancelled(status) ? kInterrupted : ExitCodeOf(status);
}

}  // namespace celt::cli
