#include "client/cli/section.h"

#include <algorithm>
#include <cstdint>
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

constexpr char kGroup[] = "Section";
constexpr int kWidth = 14;
constexpr int kDecimals = 9;

std::string Header(const v1::Point& point) {
  std::string line = absl::StrFormat("%*s", kWidth, "iterate");
  for (const std::string& title : CoordinateTitles(point)) {
    absl::StrAppendFormat(&line, "%*s", kWidth, title);
  }
  return absl::StrCat(line, absl::StrFormat("%*s", kWidth, "time"), "\n");
}

std::string Ranges(const v1::SectionResult& result) {
  TextTable table({"", "lowest", "highest", "last"});
  const std::vector<std::string> titles = CoordinateTitles(result.last());
  const std::vector<double> last = Coordinates(result.last());
  for (int i = 0; i < std::min(result.lowest_size(), result.highest_size()); ++i) {
    if (static_cast<std::size_t>(i) >= titles.size()) break;
    table.Add({titles[i], Column(result.lowest(i), 0, kDecimals),
               Column(result.highest(i), 0, kDecimals), Column(last[i], 0, kDecimals)});
  }
  return table.Text();
}

class Section : public Analysis {
 public:
  std::string command() const override { return "section"; }
  std::string field() const override { return "section"; }
  std::string description() const override {
    return "an orbit of the section map: its iterates, or those of its inverse";
  }
  std::string example() const override { return "celt section --energy 752 --iterates 10000"; }

  void AddOptions(CLI::App& app) override {
    AddNumbers(app, "--start", {}, start_,
               {kGroup, "A,B,C", "where it starts: l,L/G,H/G of the stone, else x1,x2,..."});
    AddInteger(app, "--iterates", iterates_,
               {kGroup, "N", "iterates to record, 1 to 10^9 (default 1000)"});
    AddInteger(app, "--transient", transient_,
               {kGroup, "N", "iterates before them, which are not recorded (default 0)"});
    app.add_flag("--backward", backward_, "iterates of the inverse map")->group(kGroup);
  }

  absl::Status Fill(v1::JobSpec& spec) const override {
    v1::SectionSpec& section = *spec.mutable_section();
    if (iterates_) section.set_iterates(*iterates_);
    if (transient_) section.set_transient(*transient_);
    if (backward_) section.set_direction(v1::DIRECTION_BACKWARD);
    if (!start_) return absl::OkStatus();
    const auto start = MakePoint(spec, *start_, "--start");
    if (start.ok()) *section.mutable_start() = *start;
    return start.status();
  }

  CsvRow Csv(const v1::Record& record) const override {
    const v1::SectionRecord& section = record.section();
    CsvRow row = {{"iterate", absl::StrCat(section.iterate())}};
    AddPoint(section.point(), row);
    row.emplace_back("time", Shortest(section.time()));
    row.emplace_back("return_time",
                     section.has_return_time() ? Shortest(section.return_time()) : "");
    return row;
  }
  CsvRow Csv(const v1::Result&) const override { return {}; }

  CsvRow NodeCsv(const v1::Result& result) const override {
    constexpr int kUsualDimension = 3;
    const v1::SectionResult& section = result.section();
    CsvRow row;
    const auto add = [&](const char* stem, const google::protobuf::RepeatedField<double>& values) {
      for (int i = 0; i < std::max(values.size(), kUsualDimension); ++i) {
        row.emplace_back(absl::StrCat(stem, i + 1), i < values.size() ? Shortest(values[i]) : "");
      }
    };
    add("lowest_", section.lowest());
    add("highest_", section.highest());
    row.emplace_back("mean_return_time",
                     section.has_mean_return_time() ? Shortest(section.mean_return_time()) : "");
    return row;
  }

  std::string Brief(const v1::Result& result) const override {
    const v1::SectionResult& section = result.section();
    std::string text;
    for (int i = 0; i < std::min(section.lowest_size(), section.highest_size()); ++i) {
      absl::StrAppendFormat(&text, "[%.6g, %.6g]  ", section.lowest(i), section.highest(i));
    }
    return text;
  }

  std::string Line(const v1::Record& record) const override {
    const v1::SectionRecord& section = record.section();
    std::string line = record.sequence() == 1 ? Header(section.point()) : "";
    absl::StrAppendFormat(&line, "%*d", kWidth, section.iterate());
    for (const double x : Coordinates(section.point())) {
      absl::StrAppend(&line, Column(x, kWidth, kDecimals));
    }
    return absl::StrCat(line, Column(section.time(), kWidth, kDecimals - 3), "\n");
  }

  std::string Table(const v1::Job& job, const v1::Result& result) const override {
    const v1::SectionResult& section = result.section();
    return absl::StrCat("\nOrbit of the section map of ", SystemTitle(job.spec().system()), "\n",
                        Grouped(section.iterates()), " iterates, mean return time ",
                        Significant(section.mean_return_time(), 8), "\n\n", Ranges(section),
                        AccuracyText(section.accuracy()));
  }

 private:
  std::optional<std::vector<double>> start_;
  std::optional<std::int64_t> iterates_;
  std::optional<std::int64_t> transient_;
  bool backward_ = false;
};

}  // namespace

std::unique_ptr<Analysis> MakeSection() { return std::make_unique<Section>(); }

}  // namespace celt::cli
