#include "client/cli/manifold.h"

#include <cstdint>
#include <limits>
#include <optional>

#include "absl/strings/str_cat.h"
#include "client/cli/cycle_text.h"
#include "client/cli/format.h"
#include "client/cli/option.h"
#include "client/cli/point.h"
#include "client/cli/system_options.h"
#include "client/cli/text_table.h"

namespace celt::cli {
namespace {

constexpr char kGroup[] = "Manifold";
constexpr int kDecimals = 10;

std::string SaddleText(const v1::ManifoldResult& result, bool stable) {
  const v1::Cycle& saddle = result.saddle();
  TextTable table({});
  for (const v1::Point& point : saddle.points()) table.Add({"point", PointText(point)});
  table.Add({"multipliers", MultipliersText(saddle.multipliers(), kDecimals)});
  table.Add({"sides by", stable ? "the unstable manifold" : "the stable manifold"});
  return table.Text();
}

std::string SidesText(const v1::ManifoldResult& result) {
  TextTable table({"side", "points", "length", "ended by", "its separatrix"});
  for (const v1::ManifoldSide& side : result.sides()) {
    table.Add({SideText(side.side()), Grouped(side.points()), Significant(side.length(), 6),
               side.end(), FateText(side.fate())});
  }
  std::string text = table.Text();
  for (const v1::ManifoldSide& side : result.sides()) {
    for (const std::string& message : {side.message(), side.fate().message()}) {
      if (message.empty()) continue;
      absl::StrAppend(&text, "  side ", SideText(side.side()), ": ", message, "\n");
    }
  }
  return text;
}

class Manifold : public Analysis {
 public:
  std::string command() const override { return "manifold"; }
  std::string field() const override { return "manifold"; }
  std::string description() const override {
    return "one-dimensional unstable or stable manifold of a saddle";
  }
  std::string example() const override { return "celt manifold --energy 752 --length 3"; }

  void AddOptions(CLI::App& app) override {
    AddNumbers(app, "--near", {}, near_,
               {kGroup, "A,B,C", "guess for the saddle: l,L/G,H/G of the stone, else x1,x2,..."});
    AddInteger(app, "--period", period_, {kGroup, "K", "points of the cycle (default 1)"},
               {.highest = std::numeric_limits<std::int32_t>::max()});
    app.add_flag("--stable", stable_, "the stable manifold; default: the unstable one")
        ->group(kGroup);
    AddNumber(app, "--length", length_, {kGroup, "S", "arc length of each side (default 1)"});
    AddNumber(app, "--spacing", spacing_,
              {kGroup, "D", "most distance between neighbouring points (default 0.01)"});
    AddNumber(app, "--turning", turning_,
              {kGroup, "RAD", "most turning angle at a point (default 0.3)"});
    AddInteger(app, "--most-points", most_points_,
               {kGroup, "N", "points after which a side ends, 2 to 10^6 (default 200000)"});
  }

  absl::Status Fill(v1::JobSpec& spec) const override {
    v1::ManifoldSpec& manifold = *spec.mutable_manifold();
    if (period_) manifold.set_period(static_cast<std::int32_t>(*period_));
    manifold.set_stable(stable_);
    if (length_) manifold.set_length(*length_);
    if (spacing_) manifold.set_spacing(*spacing_);
    if (turning_) manifold.set_turning(*turning_);
    if (most_points_) manifold.set_most_points(*most_points_);
    if (!near_) return absl::OkStatus();
    const auto near = MakePoint(spec, *near_, "--near");
    if (near.ok()) *manifold.mutable_near() = *near;
    return near.status();
  }

  CsvRow Csv(const v1::Record& record) const override {
    const v1::ManifoldRecord& manifold = record.manifold();
    CsvRow row = {{"side", absl::StrCat(manifold.side())},
                  {"arc_length", Shortest(manifold.arc_length())},
                  {"generation", absl::StrCat(manifold.generation())}};
    AddPoint(manifold.point(), row);
    return row;
  }
  CsvRow Csv(const v1::Result&) const override { return {}; }

  CsvRow NodeCsv(const v1::Result& result) const override {
    const v1::ManifoldResult& manifold = result.manifold();
    CsvRow row = {{"saddle", manifold.saddle().type()}};
    for (int i = 0; i < 2; ++i) {
      const bool there = i < manifold.sides_size();
      const v1::ManifoldSide& side =
          there ? manifold.sides(i) : v1::ManifoldSide::default_instance();
      const v1::SeparatrixFate& fate = side.fate();
      const std::string name = i == 0 ? "plus_" : "minus_";
      row.emplace_back(name + "length", there ? Shortest(side.length()) : "");
      row.emplace_back(name + "end", side.end());
      row.emplace_back(name + "fate", fate.end());
      row.emplace_back(name + "fate_side", there ? absl::StrCat(fate.side()) : "");
      row.emplace_back(name + "fate_changes", there ? absl::StrCat(fate.changes()) : "");
    }
    return row;
  }

  std::string Brief(const v1::Result& result) const override {
    const v1::ManifoldResult& manifold = result.manifold();
    std::string text = manifold.saddle().type();
    for (const v1::ManifoldSide& side : manifold.sides()) {
      absl::StrAppend(&text, "; ", SideText(side.side()), " ", FateText(side.fate()));
    }
    return text;
  }

  std::string Table(const v1::Job& job, const v1::Result& result) const override {
    const v1::ManifoldResult& manifold = result.manifold();
    const bool stable = job.spec().manifold().stable();
    return absl::StrCat(stable ? "Stable" : "Unstable", " manifold of a ", manifold.saddle().type(),
                        " of ", SystemTitle(job.spec().system()), "\n\n",
                        SaddleText(manifold, stable), "\n", SidesText(manifold), "\n",
                        AccuracyText(manifold.accuracy()));
  }

 private:
  std::optional<std::vector<double>> near_;
  std::optional<std::int64_t> period_;
  bool stable_ = false;
  std::optional<double> length_;
  std::optional<double> spacing_;
  std::optional<double> turning_;
  std::optional<std::int64_t> most_points_;
};

}  // namespace

std::unique_ptr<Analysis> MakeManifold() { return std::make_unique<Manifold>(); }

}  // namespace celt::cli
