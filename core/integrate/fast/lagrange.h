#pragma once

#include <array>
#include <cstddef>

namespace celt::fast {

/// Entry (k, j): coefficient of θ^(k+1) in the integral from 0 to θ of the Lagrange polynomial of
/// node j.
template <class Real, std::size_t kPoints>
using LagrangeTable = std::array<std::array<Real, kPoints>, kPoints>;

template <class Real, std::size_t kPoints>
constexpr LagrangeTable<Real, kPoints> IntegratedLagrange(const std::array<Real, kPoints>& nodes) {
  LagrangeTable<Real, kPoints> table{};
  for (std::size_t j = 0; j < kPoints; ++j) {
    std::array<Real, kPoints> product{1};
    std::size_t degree = 0;
    for (std::size_t i = 0; i < kPoints; ++i) {
      if (i == j) continue;
      const Real scale = 1 / (nodes[j] - nodes[i]);
      ++degree;
      for (std::size_t k = degree; k > 0; --k) {
        product[k] = scale * (product[k - 1] - nodes[i] * product[k]);
      }
      product[0] = scale * (0 - nodes[i] * product[0]);
    }
    for (std::size_t k = 0; k < kPoints; ++k) table[k][j] = product[k] / static_cast<Real>(k + 1);
  }
  return table;
}

/// Σ weights[j] p(node j) is the integral of p from 0 to `end`, for polynomials p of a degree less
/// than the number of nodes.
template <class Real, std::size_t kPoints>
constexpr std::array<Real, kPoints> IntegralWeights(const LagrangeTable<Real, kPoints>& table,
                                                    Real end) {
  std::array<Real, kPoints> weights = table[kPoints - 1];
  for (std::size_t k = kPoints - 1; k > 0; --k) {
    for (std::size_t j = 0; j < kPoints; ++j) weights[j] = weights[j] * end + table[k - 1][j];
  }
  for (Real& weight : weights) weight *= end;
  return weights;
}

}  // namespace celt::fast
