#include "client/cli/separatrix.h"

#include <cstdint>
#include <limits>
#include <optional>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/cli/cycle_text.h"
#include "client/cli/format.h"
#include "client/cli/option.h"
#include "client/cli/point.h"
#include "client/cli/system_options.h"
#include "client/cli/text_table.h"

namespace celt::cli {
namespace {

constexpr char kGroup[] = "Separatrix";
constexpr int kDecimals = 10;

class Separatrix : public Analysis {
 public:
  std::string command() const override { return "separatrix"; }
  std::string field() const override { return "separatrix"; }
  std::string description() const override {
    return "The value of a parameter at which a separatrix changes its fate";
  }
  std::string example() const override { return "celt separatrix --from 748.4 --to 748.5"; }

  void AddOptions(CLI::App& app) override {
    constexpr IntegerRange kInt32 = {.highest = std::numeric_limits<std::int32_t>::max()};
    AddChoice(app, "--question", {"returns", "tends"}, question_,
              {kGroup, "returns|tends", "comes back on its side (default), or ends at a cycle?"});
    app.add_option("--parameter", parameter_,
                   "energy (default), delta or another; see 'celt server info'")
        ->group(kGroup)
        ->type_name("NAME");
    AddNumber(app, "--from", from_, {kGroup, "VALUE", "an end of the interval to be halved"});
    AddNumber(app, "--to", to_, {kGroup, "VALUE", "the other end; the answers must differ"});
    AddNumber(app, "--width", width_,
              {kGroup, "W", "of the bracket asked for (default 1e-7; 1e-3 for tends)"});
    AddNumbers(app, "--near", {}, near_,
               {kGroup, "A,B,C", "a guess for the saddle at --from (default: known start)"});
    AddInteger(app, "--period", period_,
               {kGroup, "K", "points of the saddle cycle, 1 to 256 (default 1)"}, kInt32);
    AddInteger(app, "--side", side_, {kGroup, "1|-1", "which separatrix (default 1)"},
               {.lowest = -1, .highest = 1});
    AddInteger(app, "--most-iterates", most_iterates_,
               {kGroup, "N", "after which a fate is undecided, 1 to 10^7 (default 20000)"});
  }

  absl::Status Fill(v1::JobSpec& spec) const override {
    v1::SeparatrixSpec& separatrix = *spec.mutable_separatrix();
    if (question_) {
      separatrix.set_question(*question_ == 0 ? v1::SEPARATRIX_QUESTION_RETURNS
                                              : v1::SEPARATRIX_QUESTION_TENDS);
    }
    if (!parameter_.empty()) separatrix.set_parameter(parameter_);
    if (from_) separatrix.set_from(*from_);
    if (to_) separatrix.set_to(*to_);
    if (width_) separatrix.set_width(*width_);
    if (period_) separatrix.set_period(static_cast<std::int32_t>(*period_));
    if (side_) separatrix.set_side(static_cast<std::int32_t>(*side_));
    if (most_iterates_) separatrix.set_most_iterates(*most_iterates_);
    if (!near_) return absl::OkStatus();
    const auto near = MakePoint(spec, *near_, "--near");
    if (near.ok()) *separatrix.mutable_near() = *near;
    return near.status();
  }

  CsvRow Csv(const v1::Record& record) const override {
    const v1::SeparatrixRecord& looked = record.separatrix();
    const v1::SeparatrixFate& fate = looked.fate();
    CsvRow row = {{"value", Shortest(looked.value())},
                  {"answer", looked.answer() ? "yes" : "no"},
                  {"end", fate.end()},
                  {"side", absl::StrCat(fate.side())},
                  {"changes", absl::StrCat(fate.changes())},
                  {"iterates", absl::StrCat(fate.iterates())}};
    AddPoint(fate.point(), row);
    return row;
  }
  CsvRow Csv(const v1::Result&) const override { return {}; }

  CsvRow NodeCsv(const v1::Result& result) const override {
    const v1::SeparatrixResult& bracket = result.separatrix();
    const bool there = bracket.has_value();
    return {{"switches_at", there ? Shortest(bracket.value()) : ""},
            {"switches_at_error", there ? Shortest(bracket.error()) : ""},
            {"yes_end", bracket.yes_fate().end()},
            {"no_end", bracket.no_fate().end()}};
  }

  std::string Brief(const v1::Result& result) const override {
    const v1::SeparatrixResult& bracket = result.separatrix();
    return absl::StrCat("switches at ", WithError(bracket.value(), bracket.error()));
  }

  std::string Line(const v1::Record& record) const override {
    const v1::SeparatrixRecord& looked = record.separatrix();
    return absl::StrFormat("%17s  %-3s  %s\n", Decimals(looked.value(), kDecimals),
                           looked.answer() ? "yes" : "no", FateText(looked.fate()));
  }
  std::string Table(const v1::Job& job, const v1::Result& result) const override {
    return SeparatrixTable(job.spec(), result.separatrix());
  }

 private:
  std::optional<int> question_;
  std::string parameter_;
  std::optional<double> from_;
  std::optional<double> to_;
  std::optional<double> width_;
  std::optional<std::vector<double>> near_;
  std::optional<std::int64_t> period_;
  std::optional<std::int64_t> side_;
  std::optional<std::int64_t> most_iterates_;
};

}  // namespace

std::unique_ptr<Analysis> MakeSeparatrix() { return std::make_unique<Separatrix>(); }

std::string SeparatrixTable(const v1::JobSpec& spec, const v1::SeparatrixResult& result) {
  const v1::SeparatrixSpec& asked = spec.separatrix();
  const bool tends = asked.question() == v1::SEPARATRIX_QUESTION_TENDS;
  TextTable table({});
  table.Add({"yes", Decimals(result.yes(), kDecimals), FateText(result.yes_fate())});
  table.Add({"no", Decimals(result.no(), kDecimals), FateText(result.no_fate())});
  table.Add({"saddle", PointText(result.saddle())});
  return absl::StrCat(
      "\nSeparatrix ", SideText(asked.side()), " of a saddle of ", spec.system().name(), ": ",
      tends ? "does it end at a cycle?" : "does it come back on its side?", "\n",
      "the answer switches at ", asked.parameter(), " ", WithError(result.value(), result.error()),
      "\n\n", table.Text(), AccuracyText(result.accuracy()));
}

}  // namespace celt::cli
