// Compiled once for each SIMD target: included by files that go through hwy/foreach_target.h.
//
// Two groups of lanes that hand ways on to each other. A step that follows one of its own length
// takes a fifth fewer stages (two_step.h), but all lanes of a vector step alike; so the steps that
// do not, the first of a way, the last, which goes to the section, and such as the error estimate
// shortens, are taken by a group of their own, and there as many at a time as come together.
#if defined(CELT_FAST_RELAY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CELT_FAST_RELAY_INL_H_
#undef CELT_FAST_RELAY_INL_H_
#else
#define CELT_FAST_RELAY_INL_H_
#endif

#include <utility>

#include "core/integrate/crossing.h"
#include "core/integrate/fast/lanes-inl.h"
#include "core/integrate/fast/lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace celt::fast::HWY_NAMESPACE {

template <class Layout>
class Relay {
 public:
  Relay(const Problem& problem, Direction direction)
      : single_(problem, direction), steady_(problem, direction) {}

  /// Takes a step of one of the groups. False when there is nothing left to do.
  bool Advance(CrossingFeed& feed) {
    while (!to_steady_.empty() && steady_.busy() < kN) steady_.Put(to_steady_.Pop());
    while (!to_single_.empty() && single_.busy() < kN) single_.Put(to_single_.Pop());
    // Up to twice as many under way as lanes: memory does not grow with the number of orbits.
    while (single_.busy() + to_single_.size() + to_steady_.size() < kN && single_.Begin(feed)) {
    }
    if (single_.busy() == 0 && steady_.busy() == 0) return false;
    if (SinglesAreDue()) {
      single_.Advance(feed, [this](const auto& flight) { to_steady_.Push(flight); });
      if (single_.busy() == 0) waited_ = 0;
    } else {
      if (single_.busy() > 0) waited_ += kN - steady_.busy();
      steady_.Advance(feed, [this](const auto& flight) { to_single_.Push(flight); });
    }
    return true;
  }

 private:
  static constexpr int kN = Layout::kOrbits;

  /// First in, first out.
  class Queue {
   public:
    bool empty() const { return size_ == 0; }
    int size() const { return size_; }
    void Push(const Flight<Layout>& flight) { flights_[(first_ + size_++) % kCapacity] = flight; }
    const Flight<Layout>& Pop() {
      --size_;
      return flights_[std::exchange(first_, (first_ + 1) % kCapacity)];
    }

   private:
    static constexpr int kCapacity = 2 * kN;
    Flight<Layout> flights_[kCapacity];
    int first_ = 0;
    int size_ = 0;
  };

  /// When the vector is full, or when lanes have been idle for as long as the two steps take that
  /// bring a way down and send the next one off. Who waits for so long at most never pays more than
  /// twice what would have been best, and ways that come down at nearly the same time stay
  /// together.
  bool SinglesAreDue() const {
    constexpr int kPatience = 2 * kN;  // lanes × steps
    if (single_.busy() == 0) return false;
    return single_.busy() == kN || steady_.busy() == 0 || waited_ >= kPatience;
  }

  Group<Layout, Memory::kNone> single_;
  Group<Layout, Memory::kStepBefore> steady_;
  Queue to_single_;
  Queue to_steady_;
  int waited_ = 0;
};

}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CELT_FAST_RELAY_INL_H_
