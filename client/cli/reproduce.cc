#include "client/cli/reproduce.h"

#include <string>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/cli/figures.h"
#include "client/cli/format.h"

namespace celt::cli {
namespace {

constexpr char kGroup[] = "Reproduction";
constexpr int kRemark = 15;  // column where a remark begins, under its row's quantity

std::string Mark(v1::ReproduceVerdict verdict) {
  switch (verdict) {
    case v1::AGREES:
    case v1::HOLDS:
      return "✓";
    default:
      return "✗";
  }
}

std::string Padded(const std::string& text, int width) {
  return text + std::string(std::max(1, width - Width(text)), ' ');
}

std::string Columns(const std::string& mark, const std::string& section,
                    const std::string& quantity, const std::string& paper,
                    const std::string& computed) {
  constexpr int kSection = 8;
  constexpr int kQuantity = 52;
  constexpr int kPaper = 20;
  return absl::StrCat("  ", Padded(mark, 3), Padded(section, kSection), Padded(quantity, kQuantity),
                      Padded(paper, kPaper), computed, "\n");
}

class Reproduce : public Analysis {
 public:
  std::string command() const override { return "reproduce"; }
  std::string field() const override { return "reproduce"; }
  std::string description() const override {
    return "The paper's table: each of its numbers beside the computed one";
  }
  std::string example() const override { return "celt reproduce --quick"; }

  void AddOptions(CLI::App& app) override {
    app.add_flag("--quick", quick_, "fewer iterates: done in a minute")->group(kGroup);
    app.add_option("--figures", figures_,
                   "makes the paper's figures in this folder too, by gnuplot")
        ->type_name("DIR")
        ->group(kGroup);
  }

  absl::Status Fill(v1::JobSpec& spec) const override {
    spec.mutable_reproduce()->set_quick(quick_);
    return absl::OkStatus();
  }

  CsvRow Csv(const v1::Record& record) const override {
    const v1::ReproduceRecord& row = record.reproduce();
    return {{"section", row.section()},
            {"quantity", row.quantity()},
            {"paper", row.paper()},
            {"computed", row.computed()},
            {"error", row.has_error() ? Shortest(row.error()) : ""},
            {"verdict", v1::ReproduceVerdict_Name(row.verdict())},
            {"remark", row.remark()}};
  }
  CsvRow Csv(const v1::Result&) const override { return {}; }

  std::string Line(const v1::Record& record) const override {
    const v1::ReproduceRecord& row = record.reproduce();
    std::string line =
        record.sequence() == 1 ? Columns("", "section", "", "paper", "computed") : "";
    std::string computed = row.computed();
    if (row.has_error()) absl::StrAppend(&computed, " ± ", Significant(row.error(), 2));
    absl::StrAppend(
        &line, Columns(Mark(row.verdict()), row.section(), row.quantity(), row.paper(), computed));
    if (!row.remark().empty()) {
      absl::StrAppend(&line, std::string(kRemark, ' '), row.remark(), "\n");
    }
    return line;
  }

  std::string Table(const v1::Job&, const v1::Result& result) const override {
    return absl::StrCat("\n", result.reproduce().agree(), " rows agree or hold, ",
                        result.reproduce().differ(), " do not\n");
  }

  ExitCode Afterwards(const Session& session) const override {
    return figures_.empty() ? kDone : MakeFigures(session, figures_);
  }

 private:
  bool quick_ = false;
  std::string figures_;
};

}  // namespace

std::unique_ptr<Analysis> MakeReproduce() { return std::make_unique<Reproduce>(); }

}  // namespace celt::cli
