#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/analysis/branch.h"
#include "core/map/map_family.h"
#include "core/map/system.h"
#include "gtest/gtest.h"

namespace celt {

/// A system as a family in one of its parameters.
inline MapFamily FamilyOf(const System& system, const std::string& name, Parameters others,
                          const Numerics& numerics = {}) {
  return [&system, name, others = std::move(others), numerics](double value) {
    Parameters parameters = others;
    parameters[name] = value;
    return system.MakeMap(parameters, numerics);
  };
}

inline BranchStretch WholeBranch(const MapFamily& family, const ContinuationOptions& options,
                                 BranchState& state) {
  auto stretch = AdvanceBranch(family, options, state, options.most_points, [] { return true; });
  EXPECT_TRUE(stretch.ok()) << stretch.status();
  return *std::move(stretch);
}

inline BranchState Start(const MapFamily& family, const ContinuationOptions& options,
                         const std::vector<Point>& guess) {
  auto state = StartBranch(family, guess, options);
  EXPECT_TRUE(state.ok()) << state.status();
  return *std::move(state);
}

inline std::vector<Bifurcation> OfType(const std::vector<Bifurcation>& all, BifurcationType type) {
  std::vector<Bifurcation> some;
  for (const Bifurcation& bifurcation : all) {
    if (bifurcation.type == type) some.push_back(bifurcation);
  }
  return some;
}

}  // namespace celt
