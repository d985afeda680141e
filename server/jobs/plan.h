#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace celt::jobs {

/// A place in a plan. Units of one chain follow each other, each from the checkpoint that the one
/// before left; units of different chains are independent. The plan's order is by step first, then
/// by chain.
struct UnitId {
  std::int64_t step = 0;
  std::int64_t chain = 0;
  // clang-tidy 14 takes the comparison with 0 for one with a pointer.
  // NOLINTNEXTLINE(modernize-use-nullptr)
  auto operator<=>(const UnitId&) const = default;
};

/// What a work unit leaves behind. All strings are opaque bytes to everyone but the plan.
struct UnitOutput {
  std::string checkpoint;    ///< from where the chain's next unit goes on
  std::string payload;       ///< for Plan::Collect
  double work = 0;           ///< done by this unit, in the plan's unit of work
  bool chain_ended = false;  ///< no unit follows in this chain, whatever Plan::steps() says
};

/// What collecting a unit's payload gives.
struct Collected {
  std::string state;                 ///< for the next Collect, finally for Finish
  std::vector<std::string> records;  ///< zero or more, streamed to the job's readers in this order
};

/// How much there is to do: what progress is measured in.
struct Work {
  double total = 0;
  std::string unit;  ///< plural, such as "iterates"
};

/// Asked now and then by a running unit; true means: return CANCELLED soon.
using StopRequested = std::function<bool()>;

/// The deterministic plan of a job: chains of work units, whose payloads are folded in the plan's
/// order into records and a result. The same specification gives the same bytes, whatever the
/// threads and however often it is interrupted, because units are pure functions and the fold is
/// ordered. Immutable; safe to use from many threads.
class Plan {
 public:
  virtual ~Plan() = default;

  virtual std::int64_t chains() const = 0;
  /// Length of the longest chain.
  virtual std::int64_t steps() const = 0;
  virtual Work work() const = 0;

  /// Does one unit. `checkpoint` is empty for step 0. A failure fails the job; CANCELLED only after
  /// `stop` said so.
  virtual absl::StatusOr<UnitOutput> Run(UnitId unit, std::string_view checkpoint,
                                         const StopRequested& stop) const = 0;

  /// Folds a payload into the state; called in the plan's order, never twice for a unit. `state` is
  /// empty at first.
  virtual absl::StatusOr<Collected> Collect(UnitId unit, std::string_view state,
                                            std::string_view payload) const = 0;

  /// The result, from the state after the last unit.
  virtual absl::StatusOr<std::string> Finish(std::string_view state) const = 0;
};

/// Makes the plan of a specification (serialized, resolved). INVALID_ARGUMENT names the field that
/// is wrong.
using PlanFactory =
    std::function<absl::StatusOr<std::unique_ptr<Plan>>(std::string_view specification)>;

}  // namespace celt::jobs
