#include "client/cli/fixed_point.h"

#include <cstdint>
#include <limits>
#include <optional>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/cli/cycle_text.h"
#include "client/cli/fixed_point_table.h"
#include "client/cli/format.h"
#include "client/cli/option.h"
#include "client/cli/point.h"
#include "client/cli/system_options.h"

namespace celt::cli {
namespace {

constexpr char kGroup[] = "Fixed points and cycles";
constexpr int kUsualDimension = 3;

class FixedPoint : public Analysis {
 public:
  std::string command() const override { return "fixed-point"; }
  std::string field() const override { return "fixed_point"; }
  std::string description() const override {
    return "Fixed points and cycles: multipliers, type, the paper's test";
  }
  std::string example() const override { return "celt fixed-point --energy 752 --search 200"; }

  void AddOptions(CLI::App& app) override {
    constexpr IntegerRange kInt32 = {.highest = std::numeric_limits<std::int32_t>::max()};
    AddInteger(app, "--period", period_, {kGroup, "K", "points of the cycle, 1 to 256 (default 1)"},
               kInt32);
    AddNumbers(
        app, "--near", {}, near_,
        {kGroup, "A,B,C", "a guess for a point: l,L/G,H/G or x1,x2,... (default: known start)"});
    AddInteger(app, "--search", search_,
               {kGroup, "N", "look for all of them from N starts drawn in a box, 1 to 10^7"});
    AddNumbers(app, "--lower", {}, lower_,
               {kGroup, "A,B,C", "corner of the box (default: 0,-1,-1, the stone's whole domain)"});
    AddNumbers(app, "--upper", {}, upper_,
               {kGroup, "A,B,C", "the opposite corner (default: 2 pi,1,1 of the stone)"});
    AddUnsigned(app, "--seed", seed_,
                {kGroup, "N", "draws the starts; same seed, same answer (default 1)"});
    AddNumber(app, "--newton-tolerance", newton_tolerance_,
              {kGroup, "EPS", "length of the last correction, in (0, 1] (default 1e-10)"});
    AddInteger(app, "--newton-iterations", newton_iterations_,
               {kGroup, "N", "corrections before it gives up, 1 to 10000 (default 50)"}, kInt32);
  }

  absl::Status Fill(v1::JobSpec& spec) const override {
    v1::FixedPointSpec& fixed_point = *spec.mutable_fixed_point();
    if (period_) fixed_point.set_period(static_cast<std::int32_t>(*period_));
    if (search_) fixed_point.set_search(*search_);
    if (seed_) fixed_point.set_seed(*seed_);
    if (newton_tolerance_) fixed_point.set_newton_tolerance(*newton_tolerance_);
    if (newton_iterations_) {
      fixed_point.set_newton_iterations(static_cast<std::int32_t>(*newton_iterations_));
    }
    return FillPoints(spec);
  }

  CsvRow Csv(const v1::Record& record) const override {
    const v1::FixedPointRecord& found = record.fixed_point();
    CsvRow row;
    AddCycle(found.cycle(), row);
    row.emplace_back("first_start",
                     found.has_first_start() ? absl::StrCat(found.first_start()) : "");
    return row;
  }
  CsvRow Csv(const v1::Result&) const override { return {}; }

  /// Of the first cycle; coordinates and multipliers by number, whatever the system.
  CsvRow NodeCsv(const v1::Result& result) const override {
    const v1::FixedPointResult& found = result.fixed_point();
    const bool any = found.cycles_size() > 0;
    const v1::Cycle& cycle = any ? found.cycles(0) : v1::Cycle::default_instance();
    const std::vector<double> x = any ? Coordinates(cycle.points(0)) : std::vector<double>();
    CsvRow row = {{"cycles", absl::StrCat(found.cycles_size())},
                  {"type", cycle.type()},
                  {"return_time", any ? Shortest(cycle.return_time()) : ""}};
    for (std::size_t i = 0; i < kUsualDimension; ++i) {
      row.emplace_back(absl::StrCat("x_", i + 1), i < x.size() ? Shortest(x[i]) : "");
    }
    for (int i = 0; i < kUsualDimension; ++i) {
      const bool there = i < cycle.multipliers_size();
      row.emplace_back(absl::StrCat("multiplier_re_", i + 1),
                       there ? Shortest(cycle.multipliers(i).re()) : "");
      row.emplace_back(absl::StrCat("multiplier_im_", i + 1),
                       there ? Shortest(cycle.multipliers(i).im()) : "");
    }
    return row;
  }

  std::string Brief(const v1::Result& result) const override {
    std::vector<std::string> cycles;
    for (const v1::Cycle& cycle : result.fixed_point().cycles()) {
      cycles.push_back(absl::StrCat(cycle.type(), " at ", PointText(cycle.points(0))));
    }
    return absl::StrJoin(cycles, "; ");
  }

  std::string Table(const v1::Job& job, const v1::Result& result) const override {
    return FixedPointTable(job.spec(), result.fixed_point());
  }

 private:
  absl::Status FillPoints(v1::JobSpec& spec) const {
    const auto fill = [&spec](const std::optional<std::vector<double>>& numbers, const char* option,
                              v1::Point* (v1::FixedPointSpec::*corner)()) {
      if (!numbers) return absl::OkStatus();
      const auto point = MakePoint(spec, *numbers, option);
      if (point.ok()) *(spec.mutable_fixed_point()->*corner)() = *point;
      return point.status();
    };
    absl::Status status = fill(near_, "--near", &v1::FixedPointSpec::mutable_near);
    if (status.ok()) status = fill(lower_, "--lower", &v1::FixedPointSpec::mutable_lower);
    if (status.ok()) status = fill(upper_, "--upper", &v1::FixedPointSpec::mutable_upper);
    return status;
  }

  std::optional<std::int64_t> period_;
  std::optional<std::vector<double>> near_;
  std::optional<std::int64_t> search_;
  std::optional<std::vector<double>> lower_;
  std::optional<std::vector<double>> upper_;
  std::optional<std::uint64_t> seed_;
  std::optional<double> newton_tolerance_;
  std::optional<std::int64_t> newton_iterations_;
};

}  // namespace

std::unique_ptr<Analysis> MakeFixedPoint() { return std::make_unique<FixedPoint>(); }

}  // namespace celt::cli
