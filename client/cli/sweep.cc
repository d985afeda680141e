#include "client/cli/sweep.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "client/cli/continuation.h"
#include "client/cli/fixed_point.h"
#include "client/cli/format.h"
#include "client/cli/hyperbolicity.h"
#include "client/cli/lyapunov.h"
#include "client/cli/manifold.h"
#include "client/cli/option.h"
#include "client/cli/parse.h"
#include "client/cli/regime.h"
#include "client/cli/section.h"
#include "client/cli/separatrix.h"
#include "client/cli/text_table.h"
#include "google/protobuf/descriptor.h"
#include "google/protobuf/message.h"

namespace celt::cli {
namespace {

constexpr char kGroup[] = "Sweep";

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

/// Copies a part that two messages have under one name, such as an analysis.
void CopyPart(const Message& from, const std::string& name, Message& to) {
  const FieldDescriptor* const source = from.GetDescriptor()->FindFieldByName(name);
  const FieldDescriptor* const target = to.GetDescriptor()->FindFieldByName(name);
  to.GetReflection()
      ->MutableMessage(&to, target)
      ->CopyFrom(from.GetReflection()->GetMessage(from, source));
}

/// What is set of a record's outcomes: the name of an analysis, or "error".
std::string OutcomeOf(const v1::SweepRecord& record) {
  const auto* const oneof = record.GetDescriptor()->FindOneofByName("outcome");
  const FieldDescriptor* const set = record.GetReflection()->GetOneofFieldDescriptor(record, oneof);
  return set == nullptr ? "" : set->name();
}

/// "name=from:to:nodes".
absl::StatusOr<v1::Axis> ParseAxis(const std::string& text) {
  const std::vector<std::string> sides = absl::StrSplit(text, absl::MaxSplits('=', 1));
  const std::vector<std::string> numbers =
      absl::StrSplit(sides.size() == 2 ? sides[1] : std::string(), ':');
  if (sides.size() != 2 || sides[0].empty() || numbers.size() != 3) {
    return absl::InvalidArgumentError(absl::StrCat("'", text, "' is not NAME=FROM:TO:NODES"));
  }
  const auto from = ParseNumber(numbers[0]);
  const auto to = ParseNumber(numbers[1]);
  const auto nodes = ParseInteger(numbers[2], 0, std::numeric_limits<std::int32_t>::max());
  for (const absl::Status& status : {from.status(), to.status(), nodes.status()}) {
    if (!status.ok()) return status;
  }
  v1::Axis axis;
  axis.set_parameter(sides[0]);
  axis.set_from(*from);
  axis.set_to(*to);
  axis.set_nodes(static_cast<std::int32_t>(*nodes));
  return axis;
}

class Sweep : public Analysis {
 public:
  Sweep() {
    inner_.push_back(MakeLyapunov());
    inner_.push_back(MakeSection());
    inner_.push_back(MakeFixedPoint());
    inner_.push_back(MakeContinuation());
    inner_.push_back(MakeManifold());
    inner_.push_back(MakeSeparatrix());
    inner_.push_back(MakeHyperbolicity());
  }

  std::string command() const override { return "sweep"; }
  std::string field() const override { return "sweep"; }
  std::string description() const override {
    return "An analysis at each node of a grid over one or two parameters";
  }
  std::string example() const override {
    return "celt sweep --axis energy=752:752.01:101 lyapunov --iterates 20000";
  }

  void AddOptions(CLI::App& app) override {
    const auto read = [this](const std::vector<std::string>& texts) {
      for (const std::string& text : texts) {
        const auto axis = ParseAxis(text);
        if (!axis.ok()) throw CLI::ValidationError("--axis", std::string(axis.status().message()));
        axes_.push_back(*axis);
      }
      return true;
    };
    app.add_option("--axis", read,
                   "a parameter and its values; twice for a chart, the first varies "
                   "fastest")
        ->type_name("NAME=FROM:TO:NODES")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->group(kGroup);
    app.add_flag("--follow", follow_,
                 "carry the attractor along the first axis: each node starts where the one before "
                 "ended")
        ->group(kGroup);
    app.require_subcommand(1);
    for (const auto& analysis : inner_) {
      CLI::App* const inner = app.add_subcommand(analysis->command(), analysis->description());
      inner->fallthrough()->group("What to compute at each node");
      analysis->AddOptions(*inner);
      inner->callback([this, chosen = analysis.get()] { chosen_ = chosen; });
    }
  }

  absl::Status Fill(v1::JobSpec& spec) const override {
    v1::JobSpec node = spec;
    if (absl::Status status = chosen_->Fill(node); !status.ok()) return status;
    v1::SweepSpec& sweep = *spec.mutable_sweep();
    for (const v1::Axis& axis : axes_) *sweep.add_axes() = axis;
    sweep.set_follow(follow_);
    CopyPart(node, chosen_->field(), sweep);
    return absl::OkStatus();
  }

  CsvRow Csv(const v1::Record& record) const override {
    const v1::SweepRecord& sweep = record.sweep();
    CsvRow row = {{"node", absl::StrCat(sweep.node())}};
    for (int i = 0; i < sweep.values_size(); ++i) {
      row.emplace_back(absl::StrCat("value_", i + 1), Shortest(sweep.values(i)));
    }
    row.emplace_back("error", sweep.error().message());
    // A node that failed has the same columns as the others.
    for (auto& cell : InnerFor(sweep).NodeCsv(ResultOf(sweep))) row.push_back(std::move(cell));
    return row;
  }
  CsvRow Csv(const v1::Result&) const override { return {}; }

  std::string Line(const v1::Record& record) const override {
    const v1::SweepRecord& sweep = record.sweep();
    std::vector<std::string> values;
    for (const double value : sweep.values()) values.push_back(Shortest(value));
    const std::string what =
        sweep.has_error() ? "✗ " + sweep.error().message() : InnerFor(sweep).Brief(ResultOf(sweep));
    return absl::StrCat("  ", absl::StrJoin(values, "  "), "  ", what, "\n");
  }

  std::string Table(const v1::Job& job, const v1::Result& result) const override {
    const v1::SweepResult& sweep = result.sweep();
    std::string text =
        absl::StrCat("\nSweep of ", SystemTitle(job.spec().system()), "\n", Grouped(sweep.nodes()),
                     " nodes, ", Grouped(sweep.failed()), " failed\n");
    TextTable table({});
    for (const v1::RegimeCount& count : sweep.regimes()) {
      table.Add({RegimeName(count.regime()), Grouped(count.nodes())});
    }
    if (sweep.regimes_size() > 0) absl::StrAppend(&text, "\n", table.Text());
    return text;
  }

 private:
  const Analysis& InnerFor(const v1::SweepRecord& sweep) const {
    const std::string outcome = OutcomeOf(sweep);
    for (const auto& analysis : inner_) {
      if (analysis->field() == outcome) return *(last_ = analysis.get());
    }
    if (last_ != nullptr) return *last_;
    return chosen_ != nullptr ? *chosen_ : *inner_.front();
  }

  v1::Result ResultOf(const v1::SweepRecord& sweep) const {
    v1::Result result;
    CopyPart(sweep, InnerFor(sweep).field(), result);
    return result;
  }

  Analyses inner_;
  std::vector<v1::Axis> axes_;
  bool follow_ = false;
  const Analysis* chosen_ = nullptr;
  /// Of the records seen so far: a record without an answer doesn't tell.
  mutable const Analysis* last_ = nullptr;
};

}  // namespace

std::unique_ptr<Analysis> MakeSweep() { return std::make_unique<Sweep>(); }

}  // namespace celt::cli
