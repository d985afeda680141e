#pragma once

#include "core/map/system.h"

namespace celt {

/// The three-dimensional Hénon map of Gonchenko, Ovsyannikov, Simó & Turaev (2005), coordinates x,
/// y, z:
///
///     x̄ = y,   ȳ = z,   z̄ = m1 + b x + m2 y + a z + yy y² + yz yz + zz z²,      det D = b,
///
/// by default with −z² alone. The other quadratic terms are those of the generalised maps of
/// Gonchenko & Gonchenko (Physica D 337 (2016) 43), in which attractors of further types are found.
///
/// Invertible for b ≠ 0. An orbit that leaves |z| ≤ 10⁶ escapes to infinity: OUT_OF_RANGE.
const System& Henon3dSystem();

}  // namespace celt
