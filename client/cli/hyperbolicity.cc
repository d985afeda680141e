#include "client/cli/hyperbolicity.h"

#include <cstdint>
#include <optional>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/cli/format.h"
#include "client/cli/hyperbolicity_table.h"
#include "client/cli/option.h"
#include "client/cli/system_options.h"

namespace celt::cli {
namespace {

constexpr char kGroup[] = "Pseudo-hyperbolicity";

/// Of a HyperbolicityRecord or a HyperbolicityResult, which agree in these fields.
template <typename Message>
CsvRow Cells(std::int64_t iterates, const Message& message) {
  CsvRow row = {{"iterates", absl::StrCat(iterates)},
                {"minimum_angle", Shortest(message.minimum_angle())}};
  for (int i = 0; i < message.exponents_per_iterate_size(); ++i) {
    row.emplace_back(absl::StrCat("exponent_per_iterate_", i + 1),
                     Shortest(message.exponents_per_iterate(i)));
  }
  return row;
}

class Hyperbolicity : public Analysis {
 public:
  std::string command() const override { return "hyperbolicity"; }
  std::string field() const override { return "hyperbolicity"; }
  std::string description() const override {
    return "tests of pseudo-hyperbolicity: angles, LMP graph, verdict";
  }
  std::string example() const override {
    return "celt hyperbolicity --energy 752 --iterates 20000";
  }

  void AddOptions(CLI::App& app) override {
    AddInteger(app, "--iterates", iterates_,
               {kGroup, "N", "iterates along the orbit, 1900 to 10^8 (default 20000)"});
    AddInteger(app, "--transient", transient_,
               {kGroup, "N", "iterates before anything is looked at (default 2000)"});
    AddInteger(app, "--scout", scout_,
               {kGroup, "N", "iterates then from which the whitening is made (default 5000)"});
    AddUnsigned(app, "--seed", seed_, {kGroup, "N", "draws the first frame (default 1)"});
    AddNumbers(app, "--start", {}, start_,
               {kGroup, "A,B,C", "where it starts: l,L/G,H/G of the stone, else x1,x2,..."});
  }

  absl::Status Fill(v1::JobSpec& spec) const override {
    v1::HyperbolicitySpec& hyperbolicity = *spec.mutable_hyperbolicity();
    if (iterates_) hyperbolicity.set_iterates(*iterates_);
    if (transient_) hyperbolicity.set_transient(*transient_);
    if (scout_) hyperbolicity.set_scout(*scout_);
    if (seed_) hyperbolicity.set_seed(*seed_);
    if (!start_) return absl::OkStatus();
    const auto start = MakePoint(spec, *start_, "--start");
    if (start.ok()) *hyperbolicity.mutable_start() = *start;
    return start.status();
  }

  /// The history; the last record is the result's.
  CsvRow Csv(const v1::Record& record) const override {
    return Cells(record.hyperbolicity().iterates(), record.hyperbolicity());
  }
  CsvRow Csv(const v1::Result&) const override { return {}; }
  CsvRow NodeCsv(const v1::Result& result) const override {
    const v1::HyperbolicityResult& tested = result.hyperbolicity();
    const auto cell = [](bool there, double number) { return there ? Shortest(number) : ""; };
    const bool failed = tested.verdict() == v1::HYPERBOLICITY_VERDICT_UNSPECIFIED;
    return {{"verdict", failed ? "" : v1::HyperbolicityVerdict_Name(tested.verdict())},
            {"minimum_angle", cell(tested.has_minimum_angle(), tested.minimum_angle())},
            {"promised_minimum", cell(tested.has_promised_minimum(), tested.promised_minimum())},
            {"tail_index", cell(tested.has_tail_index(), tested.tail_index())}};
  }
  std::string Brief(const v1::Result& result) const override {
    const v1::HyperbolicityResult& tested = result.hyperbolicity();
    return absl::StrFormat("%-18s least angle %.5f",
                           v1::HyperbolicityVerdict_Name(tested.verdict()), tested.minimum_angle());
  }
  std::string Table(const v1::Job& job, const v1::Result& result) const override {
    return HyperbolicityTable(job.spec(), result.hyperbolicity());
  }

 private:
  std::optional<std::int64_t> iterates_;
  std::optional<std::int64_t> transient_;
  std::optional<std::int64_t> scout_;
  std::optional<std::uint64_t> seed_;
  std::optional<std::vector<double>> start_;
};

}  // namespace

std::unique_ptr<Analysis> MakeHyperbolicity() { return std::make_unique<Hyperbolicity>(); }

}  // namespace celt::cli
