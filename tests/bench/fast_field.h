#pragma once

// FastEquations as plain functions. For one source file alone, which says what machine they are
// compiled for.

#include "core/integrate/fast/section_value-inl.h"
#include "core/integrate/fast/stone_rate-inl.h"
#include "hwy/highway.h"
#include "tests/bench/odeint_crossing.h"
#include "tests/bench/place.h"

HWY_BEFORE_NAMESPACE();
namespace celt::bench {
namespace {

using One = fast::HWY_NAMESPACE::Lanes<1>;

inline void Spread(const double* x, One* out) {
  for (int i = 0; i < FastEquations::kComponents; ++i) {
    out[i] = fast::HWY_NAMESPACE::Set<One>(x[i]);
  }
}

/// The rate in time of a state and of the tangents behind it.
template <int kTangents>
void Rate(const FastEquations& equations, const double* x, double* rate) {
  using namespace fast::HWY_NAMESPACE;  // NOLINT: where the field is
  constexpr int kSize = FastEquations::kComponents;
  One in[kSize], out[kSize], scale;
  Spread(x, in);
  const fast::HWY_NAMESPACE::Stride<One> unit{Set<One>(1), Set<One>(1),
                                              Set<One>(equations.gravity)};
  Linearization<One> linear;
  fast::HWY_NAMESPACE::Rate<(kTangents > 0)>(equations.constants, unit, in, out, scale, linear);
  const double over = 1 / hn::GetLane(scale);  // from scaled time to time
  for (int i = 0; i < kSize; ++i) rate[i] = over * hn::GetLane(out[i]);
  for (int j = 1; j <= kTangents; ++j) {
    Spread(x + j * kSize, in);
    TangentRate(linear, in, out);
    for (int i = 0; i < kSize; ++i) rate[j * kSize + i] = over * hn::GetLane(out[i]);
  }
}

inline Place PlaceOf(const FastEquations& equations, const double* x) {
  using namespace fast::HWY_NAMESPACE;  // NOLINT: where the field is
  One in[FastEquations::kComponents];
  Spread(x, in);
  const auto place = Locate(equations.constants, equations.cosine, equations.sine,
                            Set<One>(equations.gravity), in);
  return {hn::GetLane(place.value), hn::GetLane(place.side)};
}

}  // namespace
}  // namespace celt::bench
HWY_AFTER_NAMESPACE();
