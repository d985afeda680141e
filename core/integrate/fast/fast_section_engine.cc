#include "core/integrate/fast/fast_section_engine.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

// This file is compiled once for each SIMD target: foreach_target.h includes it again and must come
// first.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/integrate/fast/fast_section_engine.cc"
// clang-format off
#include "hwy/foreach_target.h"
// clang-format on
#include "core/integrate/fast/relay-inl.h"
#include "hwy/aligned_allocator.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace celt::fast::HWY_NAMESPACE {

/// Works in `count` relays until all their lanes are idle and the feed has nothing for them.
template <class Layout>
void RunRelays(const Problem& problem, CrossingFeed& feed, Direction direction, int count) {
  std::vector<hwy::AlignedUniquePtr<Relay<Layout>>> relays;
  relays.reserve(count);
  for (int i = 0; i < count; ++i) {
    relays.push_back(hwy::MakeUniqueAligned<Relay<Layout>>(problem, direction));
  }
  for (bool busy = true; busy;) {
    busy = false;
    for (const auto& relay : relays) busy = relay->Advance(feed) || busy;
  }
}

template <class Vector>
void RunVectors(const Problem& problem, CrossingFeed& feed, Direction direction, bool tangents,
                int lanes) {
  const int count = std::max(1, lanes / kLanes<Vector>);
  if (tangents) {
    RunRelays<Layout<Vector, Vector, 3>>(problem, feed, direction, count);
  } else {
    RunRelays<Layout<Vector, Vector, 0>>(problem, feed, direction, count);
  }
}

void RunOne(const Problem& problem, CrossingFeed& feed, Direction direction, bool tangents) {
  if (tangents) {
    RunRelays<Layout<Lanes<1>, Lanes<4>, 1>>(problem, feed, direction, 1);
  } else {
    RunRelays<Layout<Lanes<1>, Lanes<1>, 0>>(problem, feed, direction, 1);
  }
}

void Run(const Problem& problem, CrossingFeed& feed, Direction direction, bool tangents,
         int lanes) {
  if (lanes == 1) return RunOne(problem, feed, direction, tangents);
  // Without tangents, a vector alone would wait for its own results most of the time.
  if (!tangents && (lanes == 0 || lanes >= 2 * kMaxLanes)) {
    using Two = Lanes<2 * kMaxLanes>;
    return RunRelays<Layout<Two, Two, 0>>(problem, feed, direction,
                                          std::max(1, lanes / kLanes<Two>));
  }
  if constexpr (kMaxLanes > 4) {
    if (lanes == 4) return RunVectors<Lanes<4>>(problem, feed, direction, tangents, lanes);
  }
  RunVectors<Lanes<kMaxLanes>>(problem, feed, direction, tangents, lanes);
}

}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace celt {
namespace fast {
HWY_EXPORT(Run);
}  // namespace fast

namespace {

/// A feed that is in one of two modes: a single task at a time, or several. Where all tasks handed
/// out are done and what is ready is work for the other mode, it ends.
class ModalFeed final : public CrossingFeed {
 public:
  explicit ModalFeed(CrossingFeed& feed) : feed_(feed) {}

  enum class Mode { kSingle, kSeveral, kEither };
  void set_mode(Mode mode) { mode_ = mode; }

  /// How many tasks are ready, up to two.
  int Peek() {
    while (ready_ < 2 && feed_.Next(tasks_[ready_], tickets_[ready_])) ++ready_;
    return ready_;
  }

  bool Next(CrossingTask& task, int& ticket) override {
    if (pending_ == 0 && mode_ != Mode::kEither && (Peek() == 1) != (mode_ == Mode::kSingle))
      return false;
    if (ready_ == 0) {
      if (!feed_.Next(task, ticket)) return false;
    } else {
      task = tasks_[0];
      ticket = tickets_[0];
      tasks_[0] = tasks_[1];
      tickets_[0] = tickets_[1];
      --ready_;
    }
    ++pending_;
    return true;
  }

  void Done(int ticket, const absl::Status& status, const Crossing& crossing) override {
    --pending_;
    feed_.Done(ticket, status, crossing);
  }

 private:
  CrossingFeed& feed_;
  Mode mode_ = Mode::kEither;
  int pending_ = 0;  ///< handed out and not done
  int ready_ = 0;    ///< taken from the feed and not handed out
  CrossingTask tasks_[2];
  int tickets_[2];
};

}  // namespace

struct FastSectionEngine::Impl {
  fast::Problem problem;
  int lanes;
};

namespace {

/// Step in scaled time, over tolerance^(1/9).
constexpr double kStep = 4.2;
/// What the error estimate may be in a step, over tolerance^(8/9): like the step's power of its
/// order.
constexpr double kGuard = 30;

}  // namespace

FastSectionEngine::FastSectionEngine(const CelticStone& stone, const SectionEvent& section,
                                     double tolerance, const FastOptions& options)
    : impl_(
          new Impl{.problem = {.stone = stone,
                               .event = section,
                               .constants = fast::StoneConstants(stone),
                               .tolerance = kGuard * std::pow(tolerance, 8 / 9.0),
                               .longest_step = kStep * std::pow(tolerance, 1 / 9.0),
                               .longest_time = options.limits.longest_time * 2 * std::numbers::pi *
                                               std::sqrt(std::max(stone.parameters().radius1,
                                                                  stone.parameters().radius2) /
                                                         stone.parameters().gravity),
                               .most_steps = options.limits.most_steps},
                   .lanes = options.lanes}) {}

FastSectionEngine::~FastSectionEngine() = default;

void FastSectionEngine::Run(CrossingFeed& feed, Direction direction, Derivative derivative) const {
  using namespace fast;  // where HWY_EXPORT put the table of targets
  const auto run = HWY_DYNAMIC_DISPATCH(Run);
  const bool tangents = derivative == Derivative::kJacobian;
  ModalFeed modal(feed);
  while (modal.Peek() > 0) {
    // One orbit is faster on its own than as one of many.
    int lanes = impl_->lanes;
    if (lanes == 0) {
      const bool single = modal.Peek() == 1;
      modal.set_mode(single ? ModalFeed::Mode::kSingle : ModalFeed::Mode::kSeveral);
      lanes = single ? 1 : 0;
    }
    run(impl_->problem, modal, direction, tangents, lanes);
  }
}

}  // namespace celt
#endif  // HWY_ONCE
