#include "client/cli/orbit.h"

#include <cstdint>
#include <optional>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/cli/format.h"
#include "client/cli/option.h"
#include "client/cli/point.h"
#include "client/cli/system_options.h"
#include "client/cli/text_table.h"

namespace celt::cli {
namespace {

constexpr char kGroup[] = "Orbit";
constexpr int kWidth = 12;
constexpr int kDecimals = 6;

using Doubles = google::protobuf::RepeatedField<double>;

void AddCells(const std::string& stem, const Doubles& values, CsvRow& row) {
  for (int i = 0; i < values.size(); ++i) {
    row.emplace_back(absl::StrCat(stem, "_", i + 1), Shortest(values[i]));
  }
}

/// Columns are there also where the angles are not: for gnuplot, an empty cell is no number.
void AddAndoyer(const v1::OrbitRecord& orbit, CsvRow& row) {
  const bool known = orbit.has_andoyer();
  row.emplace_back("l", known ? Shortest(orbit.andoyer().l()) : "");
  row.emplace_back("l_over_g", known ? Shortest(orbit.andoyer().l_over_g()) : "");
  row.emplace_back("h_over_g", known ? Shortest(orbit.andoyer().h_over_g()) : "");
  row.emplace_back("g", orbit.has_g() ? Shortest(orbit.g()) : "");
}

double At(const Doubles& values, int index) { return index < values.size() ? values[index] : 0; }

std::string Header() {
  std::string line;
  for (const char* title : {"time", "spin rate", "turns", "gamma3", "X", "Y"}) {
    absl::StrAppendFormat(&line, "%*s", kWidth, title);
  }
  return line + "\n";
}

class Orbit : public Analysis {
 public:
  std::string command() const override { return "orbit"; }
  std::string field() const override { return "orbit"; }
  std::string description() const override {
    return "an orbit of the stone's flow: how it turns, wobbles and rolls";
  }
  std::string example() const override {
    return "celt orbit --state 0,0,-14,0.01,0.01,0.9999 --time 40 --step 0.02";
  }

  void AddOptions(CLI::App& app) override {
    AddNumbers(app, "--start", {"l", "L/G", "H/G"}, start_,
               {kGroup, "l,L/G,H/G", "a point of the section on the level of energy"});
    AddNumbers(app, "--state", {"M1", "M2", "M3", "g1", "g2", "g3"}, state_,
               {kGroup, "M1,M2,M3,g1,g2,g3",
                "instead of --start: angular momentum and upward vertical, in body axes"});
    AddNumber(app, "--time", time_, {kGroup, "T", "length of the orbit (default 10)"});
    AddNumber(app, "--step", step_, {kGroup, "DT", "time from record to record (default 0.01)"});
    AddNumber(app, "--turns", turns_,
              {kGroup, "N", "end earlier, after so many turns about the vertical, either way"});
    app.add_flag("--backward", backward_, "backward in time")->group(kGroup);
    app.footer(
        absl::StrCat("The fast engine goes from section to section only: an orbit is then\n"
                     "advanced by arkode.\n\nExample:\n  ",
                     example()));
  }

  absl::Status Fill(v1::JobSpec& spec) const override {
    v1::OrbitSpec& orbit = *spec.mutable_orbit();
    if (time_) orbit.set_time(*time_);
    if (step_) orbit.set_step(*step_);
    if (turns_) orbit.set_turns(*turns_);
    if (backward_) orbit.set_direction(v1::DIRECTION_BACKWARD);
    if (state_) return FillState(spec);
    if (!start_ || !IsStone(spec)) return absl::OkStatus();  // the service says that it must be
    const auto start = MakePoint(spec, *start_, "--start");
    if (start.ok()) *orbit.mutable_start() = *start;
    return start.status();
  }

  CsvRow Csv(const v1::Record& record) const override {
    const v1::OrbitRecord& orbit = record.orbit();
    CsvRow row = {{"time", Shortest(orbit.time())}};
    AddCells("momentum", orbit.momentum(), row);
    AddCells("gamma", orbit.gamma(), row);
    AddCells("angular_velocity", orbit.angular_velocity(), row);
    AddCells("contact_on_body", orbit.contact_on_body(), row);
    AddCells("contact_on_plane", orbit.contact_on_plane(), row);
    row.emplace_back("heading", Shortest(orbit.heading()));
    row.emplace_back("spin_rate", Shortest(orbit.spin_rate()));
    row.emplace_back("turns", Shortest(orbit.turns()));
    AddAndoyer(orbit, row);
    row.emplace_back("momentum_length", Shortest(orbit.momentum_length()));
    row.emplace_back("energy_drift", Shortest(orbit.energy_drift()));
    row.emplace_back("gamma_drift", Shortest(orbit.gamma_drift()));
    return row;
  }
  CsvRow Csv(const v1::Result&) const override { return {}; }

  std::string Line(const v1::Record& record) const override {
    const v1::OrbitRecord& orbit = record.orbit();
    std::string line = record.sequence() == 1 ? Header() : "";
    for (const double number :
         {orbit.time(), orbit.spin_rate(), orbit.turns(), At(orbit.gamma(), 2),
          At(orbit.contact_on_plane(), 0), At(orbit.contact_on_plane(), 1)}) {
      absl::StrAppend(&line, Column(number, kWidth, kDecimals));
    }
    return line + "\n";
  }

  std::string Table(const v1::Job& job, const v1::Result& result) const override {
    const v1::OrbitResult& orbit = result.orbit();
    TextTable table({});
    table.Add({"records", Grouped(orbit.records())});
    table.Add({"time", Significant(orbit.time(), 8)});
    table.Add({"turns about the vertical", Significant(orbit.turns(), 6)});
    table.Add({"reversals of the spin", Grouped(orbit.reversals())});
    table.Add({"energy", Significant(orbit.energy(), 8)});
    table.Add({"drift of energy", Significant(orbit.energy_drift(), 2)});
    table.Add({"drift of |gamma|", Significant(orbit.gamma_drift(), 2)});
    return absl::StrCat("\nOrbit of the ", SystemTitle(job.spec().system()), "\n\n", table.Text());
  }

 private:
  absl::Status FillState(v1::JobSpec& spec) const {
    if (start_) return absl::InvalidArgumentError("--state: not together with --start");
    if (spec.system().parameters().contains("energy")) {
      return absl::InvalidArgumentError("--state: not together with --energy, it has its own");
    }
    spec.mutable_orbit()->mutable_state()->Add(state_->begin(), state_->end());
    return absl::OkStatus();
  }

  std::optional<std::vector<double>> start_;
  std::optional<std::vector<double>> state_;
  std::optional<double> time_;
  std::optional<double> step_;
  std::optional<double> turns_;
  bool backward_ = false;
};

}  // namespace

std::unique_ptr<Analysis> MakeOrbit() { return std::make_unique<Orbit>(); }

}  // namespace celt::cli
