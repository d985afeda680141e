#include "client/cli/continuation.h"

#include <cstdint>
#include <limits>
#include <optional>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "client/cli/continuation_table.h"
#include "client/cli/cycle_text.h"
#include "client/cli/format.h"
#include "client/cli/option.h"
#include "client/cli/system_options.h"

namespace celt::cli {
namespace {

constexpr char kGroup[] = "Continuation";

/// The first bifurcation of a type; nullptr: there is none.
const v1::Bifurcation* First(const v1::ContinuationResult& branches, int type) {
  for (const v1::Bifurcation& met : branches.bifurcations()) {
    if (met.type() == type) return &met;
  }
  return nullptr;
}

class Continuation : public Analysis {
 public:
  std::string command() const override { return "continue"; }
  std::string field() const override { return "continuation"; }
  std::string description() const override {
    return "A branch of cycles in one parameter and the bifurcations on it";
  }
  std::string example() const override {
    return "celt continue --parameter energy --from 752 --to 747";
  }

  void AddOptions(CLI::App& app) override {
    constexpr IntegerRange kInt32 = {.highest = std::numeric_limits<std::int32_t>::max()};
    app.add_option("--parameter", parameter_,
                   "energy (default), delta or another; see 'celt server info'")
        ->group(kGroup)
        ->type_name("NAME");
    AddNumber(app, "--from", from_,
              {kGroup, "VALUE", "where it starts (default: the system's value)"});
    AddNumber(app, "--to", to_, {kGroup, "VALUE", "where it is to end"});
    AddInteger(app, "--period", period_,
               {kGroup, "K", "points of the cycle at the start, 1 to 256 (default 1)"}, kInt32);
    AddNumbers(app, "--near", {}, near_,
               {kGroup, "A,B,C", "a guess for a point at the start (default: known start)"});
    AddNumber(app, "--longest-step", longest_step_,
              {kGroup, "S", "in arclength, the interval being about 1 (default 0.02)"});
    AddInteger(app, "--most-points", most_points_,
               {kGroup, "N", "of a branch, 2 to 100000 (default 10000)"});
    AddInteger(app, "--doublings", doublings_,
               {kGroup, "N", "period doublings at which the new branch is followed, 0 to 8"},
               kInt32);
  }

  absl::Status Fill(v1::JobSpec& spec) const override {
    v1::ContinuationSpec& continuation = *spec.mutable_continuation();
    if (!parameter_.empty()) continuation.set_parameter(parameter_);
    if (from_) continuation.set_from(*from_);
    if (to_) continuation.set_to(*to_);
    if (period_) continuation.set_period(static_cast<std::int32_t>(*period_));
    if (longest_step_) continuation.set_longest_step(*longest_step_);
    if (most_points_) continuation.set_most_points(*most_points_);
    if (doublings_) continuation.set_doublings(static_cast<std::int32_t>(*doublings_));
    if (!near_) return absl::OkStatus();
    const auto near = MakePoint(spec, *near_, "--near");
    if (near.ok()) *continuation.mutable_near() = *near;
    return near.status();
  }

  CsvRow Csv(const v1::Record& record) const override {
    const v1::ContinuationRecord& piece = record.continuation();
    const v1::Bifurcation& met = piece.bifurcation();
    const bool point = piece.has_point();
    const auto number = [](bool has, double value) { return has ? Shortest(value) : ""; };
    CsvRow row = {
        {"branch", absl::StrCat(point ? piece.point().branch() : met.branch())},
        {"bifurcation", point ? "" : v1::BifurcationType_Name(met.type())},
        {"value", Shortest(point ? piece.point().value() : met.value())},
        {"value_error", number(met.has_value_error(), met.value_error())},
        {"arclength", number(point, piece.point().arclength())},
        {"angle", number(met.has_angle(), met.angle())},
        {"coefficient", number(met.has_coefficient(), met.coefficient())},
        {"coefficient_error", number(met.has_coefficient_error(), met.coefficient_error())},
        {"criticality", met.criticality()}};
    AddCycle(point ? piece.point().cycle() : met.cycle(), row);
    return row;
  }
  CsvRow Csv(const v1::Result&) const override { return {}; }

  /// Of each kind of bifurcation the first on the way.
  CsvRow NodeCsv(const v1::Result& result) const override {
    const v1::ContinuationResult& branches = result.continuation();
    CsvRow row = {{"bifurcations", absl::StrCat(branches.bifurcations_size())}};
    for (int type = v1::BifurcationType_MIN + 1; v1::BifurcationType_IsValid(type); ++type) {
      const v1::Bifurcation* const met = First(branches, type);
      const std::string name =
          absl::AsciiStrToLower(v1::BifurcationType_Name(static_cast<v1::BifurcationType>(type)));
      row.emplace_back(name, met != nullptr ? Shortest(met->value()) : "");
      if (type != v1::PERIOD_DOUBLING && type != v1::NEIMARK_SACKER) continue;
      row.emplace_back(name + "_criticality", met != nullptr ? met->criticality() : "");
    }
    const bool any = branches.branches_size() > 0;
    row.emplace_back("to", any ? Shortest(branches.branches(0).to()) : "");
    row.emplace_back("end", any ? branches.branches(0).end() : "");
    return row;
  }

  std::string Brief(const v1::Result& result) const override {
    return ContinuationBrief(result.continuation());
  }

  std::string Line(const v1::Record& record) const override { return ContinuationLine(record); }
  std::string Table(const v1::Job& job, const v1::Result& result) const override {
    return ContinuationTable(job.spec(), result.continuation());
  }

 private:
  std::string parameter_;
  std::optional<double> from_;
  std::optional<double> to_;
  std::optional<std::int64_t> period_;
  std::optional<std::vector<double>> near_;
  std::optional<double> longest_step_;
  std::optional<std::int64_t> most_points_;
  std::optional<std::int64_t> doublings_;
};

}  // namespace

std::unique_ptr<Analysis> MakeContinuation() { return std::make_unique<Continuation>(); }

}  // namespace celt::cli
