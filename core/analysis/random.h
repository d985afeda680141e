#pragma once

#include <cstdint>

namespace celt {

/// A stream of uniform numbers in [-1, 1): SplitMix64 (Steele, Lea & Flood 2014), the same on every
/// machine.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : state_(seed) {}

  /// A stream of its own for each index, so that draws can be made in any order.
  Uniform(std::uint64_t seed, std::uint64_t index) : state_(Mixed(Mixed(seed) + index)) {}

  double operator()() {
    state_ += kWeyl;
    return static_cast<double>(Mixed(state_) >> 11U) * 0x1p-52 - 1;
  }

 private:
  static constexpr std::uint64_t kWeyl = 0x9e3779b97f4a7c15U;

  static std::uint64_t Mixed(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  std::uint64_t state_;
};

}  // namespace celt
