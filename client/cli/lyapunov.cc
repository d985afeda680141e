#include "client/cli/lyapunov.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/cli/format.h"
#include "client/cli/lyapunov_table.h"
#include "client/cli/option.h"
#include "client/cli/regime.h"
#include "client/cli/system_options.h"

namespace celt::cli {
namespace {

constexpr char kGroup[] = "Lyapunov spectrum";

constexpr int kUsualDimension = 3;

using Doubles = google::protobuf::RepeatedField<double>;

/// One cell for each exponent, empty where `values` has none.
void AddCells(const std::string& stem, const Doubles& values, int count, CsvRow& row) {
  for (int i = 0; i < count; ++i) {
    row.emplace_back(absl::StrCat(stem, "_", i + 1), i < values.size() ? Shortest(values[i]) : "");
  }
}

/// Of a LyapunovRecord or a LyapunovResult, which agree in these fields.
template <typename Message>
CsvRow Cells(const Message& message) {
  // A node of a sweep that failed has the columns of the others.
  const int count = std::max(message.exponents_per_iterate_size(), kUsualDimension);
  CsvRow row = {{"iterates", absl::StrCat(message.iterates())}};
  AddCells("exponent_per_iterate", message.exponents_per_iterate(), count, row);
  AddCells("standard_error_per_iterate", message.standard_error_per_iterate(), count, row);
  AddCells("exponent_per_time", message.exponents_per_time(), count, row);
  row.emplace_back("mean_return_time", Shortest(message.mean_return_time()));
  return row;
}

class Lyapunov : public Analysis {
 public:
  std::string command() const override { return "lyapunov"; }
  std::string field() const override { return "lyapunov"; }
  std::string description() const override {
    return "Lyapunov spectrum of an attractor, with standard errors";
  }
  std::string example() const override { return "celt lyapunov --energy 752 --iterates 20000"; }

  void AddOptions(CLI::App& app) override {
    constexpr IntegerRange kInt32 = {.highest = std::numeric_limits<std::int32_t>::max()};
    AddInteger(app, "--iterates", iterates_,
               {kGroup, "N", "iterates of the map in all, over all orbits (default 100000)"});
    AddInteger(app, "--orbits", orbits_,
               {kGroup, "N", "independent orbits, 1 to 4096 (default 16)"}, kInt32);
    AddInteger(app, "--transient", transient_,
               {kGroup, "N", "iterates of each orbit before anything is measured (default 2000)"});
    AddUnsigned(app, "--seed", seed_,
                {kGroup, "N", "draws the starts; same seed, same answer (default 1)"});
    AddNumbers(
        app, "--start", {}, start_,
        {kGroup, "A,B,C", "around which orbits start: l,L/G,H/G of the stone, else x1,x2,..."});
  }

  absl::Status Fill(v1::JobSpec& spec) const override {
    v1::LyapunovSpec& lyapunov = *spec.mutable_lyapunov();
    if (iterates_) lyapunov.set_iterates(*iterates_);
    if (orbits_) lyapunov.set_orbits(static_cast<std::int32_t>(*orbits_));
    if (transient_) lyapunov.set_transient(*transient_);
    if (seed_) lyapunov.set_seed(*seed_);
    if (!start_) return absl::OkStatus();
    const auto start = MakePoint(spec, *start_, "--start");
    if (start.ok()) *lyapunov.mutable_start() = *start;
    return start.status();
  }

  CsvRow Csv(const v1::Record& record) const override { return Cells(record.lyapunov()); }
  CsvRow Csv(const v1::Result& result) const override { return Cells(result.lyapunov()); }
  std::string Brief(const v1::Result& result) const override {
    std::string text = "Λ";
    for (const double exponent : result.lyapunov().exponents_per_iterate()) {
      absl::StrAppend(&text, absl::StrFormat(" %9.5f", exponent));
    }
    return absl::StrCat(text, "  ", RegimeName(result.lyapunov().regime()));
  }
  std::string Table(const v1::Job& job, const v1::Result& result) const override {
    return LyapunovTable(job.spec(), result.lyapunov());
  }

 private:
  std::optional<std::int64_t> iterates_;
  std::optional<std::int64_t> orbits_;
  std::optional<std::int64_t> transient_;
  std::optional<std::uint64_t> seed_;
  std::optional<std::vector<double>> start_;
};

}  // namespace

std::unique_ptr<Analysis> MakeLyapunov() { return std::make_unique<Lyapunov>(); }

}  // namespace celt::cli
