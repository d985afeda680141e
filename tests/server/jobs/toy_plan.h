#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "absl/strings/str_cat.h"
#include "server/jobs/plan.h"

namespace celt::jobs {

/// A plan small enough to see through, whose answer depends on every unit and on the order of the
/// fold.
struct Toy {
  std::int64_t chains = 3;
  std::int64_t steps = 4;
  std::map<std::int64_t, std::int64_t> lengths = {};  ///< of chains that end early
  /// Called at the start of each unit; what it returns ends the unit unless it is OK.
  std::function<absl::Status(UnitId, const StopRequested&)> on_run =
      [](UnitId, const StopRequested&) { return absl::OkStatus(); };
  std::function<absl::Status()> on_finish = [] { return absl::OkStatus(); };
};

class ToyPlan final : public Plan {
 public:
  explicit ToyPlan(Toy toy) : toy_(std::move(toy)) {}

  std::int64_t chains() const override { return toy_.chains; }
  std::int64_t steps() const override { return toy_.steps; }
  Work work() const override {
    double total = 0;
    for (std::int64_t chain = 0; chain < toy_.chains; ++chain)
      total += static_cast<double>(Length(chain));
    return {total, "units"};
  }

  absl::StatusOr<UnitOutput> Run(UnitId unit, std::string_view checkpoint,
                                 const StopRequested& stop) const override {
    if (absl::Status status = toy_.on_run(unit, stop); !status.ok()) return status;
    UnitOutput output;
    // A chain's checkpoint is its history: a unit that is left out or run twice shows.
    output.checkpoint = absl::StrCat(std::string(checkpoint), "/", unit.step);
    output.payload = absl::StrCat(unit.chain, output.checkpoint);
    output.work = 1;
    output.chain_ended = unit.step + 1 == Length(unit.chain);
    return output;
  }

  absl::StatusOr<Collected> Collect(UnitId unit, std::string_view state,
                                    std::string_view payload) const override {
    Collected collected;
    collected.state = absl::StrCat(std::string(state), "[", std::string(payload), "]");
    // Sometimes none, sometimes two.
    for (std::int64_t i = 0; i < (unit.step + unit.chain) % 3; ++i) {
      collected.records.push_back(absl::StrCat(std::string(payload), "#", i));
    }
    return collected;
  }

  absl::StatusOr<std::string> Finish(std::string_view state) const override {
    if (absl::Status status = toy_.on_finish(); !status.ok()) return status;
    return absl::StrCat("result:", std::string(state));
  }

 private:
  std::int64_t Length(std::int64_t chain) const {
    const auto found = toy_.lengths.find(chain);
    return found == toy_.lengths.end() ? toy_.steps : found->second;
  }

  Toy toy_;
};

/// Plans by their specification; one that is not among them is INVALID_ARGUMENT.
inline PlanFactory ToyFactory(std::map<std::string, Toy> toys) {
  return [toys = std::move(toys)](std::string_view name) -> absl::StatusOr<std::unique_ptr<Plan>> {
    const auto found = toys.find(std::string(name));
    if (found == toys.end()) return absl::InvalidArgumentError("toy: no such toy");
    return std::make_unique<ToyPlan>(found->second);
  };
}

}  // namespace celt::jobs
