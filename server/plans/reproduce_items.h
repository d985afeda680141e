#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "celt/v1/reproduce.pb.h"
#include "server/plans/reproduce_rows.h"

namespace celt::plans {

using ReproduceRows = std::vector<v1::ReproduceRecord>;

/// A piece of the paper's table that is computed in one go: some of its rows.
struct ReproduceItem {
  const char* section;   ///< of the paper
  const char* quantity;  ///< what it is about: for a row that says that it failed
  absl::StatusOr<ReproduceRows> (*compute)(const Reproduction& reproduction);
};

/// All of them, in the order of the paper.
std::span<const ReproduceItem> ReproduceItems();

// Their groups, each in a file of its own.

/// The saddle O*, its multipliers, its mirror image, and the spectrum of the attractor at 752.
absl::StatusOr<ReproduceRows> FixedPointRows(const Reproduction& reproduction);
absl::StatusOr<ReproduceRows> SpectrumRows(const Reproduction& reproduction);
absl::StatusOr<ReproduceRows> GraphRows(const Reproduction& reproduction);
absl::StatusOr<ReproduceRows> HyperbolicityRows(const Reproduction& reproduction);

/// The bifurcations on the way to the attractor: E1 and E4, E2, E3.
absl::StatusOr<ReproduceRows> BifurcationRows(const Reproduction& reproduction);
absl::StatusOr<ReproduceRows> ButterflyRows(const Reproduction& reproduction);
absl::StatusOr<ReproduceRows> BasinRows(const Reproduction& reproduction);

/// The attractor's stages: its birth, its destruction, the end.
absl::StatusOr<ReproduceRows> BirthRows(const Reproduction& reproduction);
absl::StatusOr<ReproduceRows> DestructionRows(const Reproduction& reproduction);
absl::StatusOr<ReproduceRows> BreakdownRows(const Reproduction& reproduction);

}  // namespace celt::plans
