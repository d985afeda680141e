#include "server/plans/load.h"

#include <algorithm>
#include <string>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "celt/v1/job.pb.h"
#include "server/plans/chosen.h"
#include "server/plans/sweep_grid.h"
#include "server/plans/sweep_node.h"

namespace celt::plans {
namespace {

/// Seconds of one thread for an iterate with its tangents, as measured on a machine of 2023.
double SecondsOfIterate(v1::Engine engine) {
  switch (engine) {
    case v1::ENGINE_FAST:
      return 1.5e-5;
    case v1::ENGINE_ARKODE:
      return 1.5e-3;
    case v1::ENGINE_CVODE:
      return 4.4e-3;
    default:
      return 3e-7;  // a formula
  }
}

/// Whether the plan's chains are as long as it says, or nearly: others end when they have found
/// what they look for.
bool TellsUnits(const v1::JobSpec& spec) {
  return !spec.has_continuation() && !spec.has_manifold() && !spec.has_separatrix();
}

std::string KindOf(const v1::JobSpec& spec, const std::string& analysis) {
  std::string engine = absl::AsciiStrToLower(v1::Engine_Name(spec.numerics().engine()));
  engine.erase(0, engine.find('_') + 1);
  return absl::StrCat(analysis, "/", spec.system().name(),
                      spec.numerics().engine() == v1::ENGINE_UNSPECIFIED ? "" : "/" + engine);
}

/// Of everything but a sweep; `work` in the unit of its plan.
jobs::Load LoadOf(const v1::JobSpec& spec, double work) {
  const Chosen chosen = AnalysisOf(spec);
  jobs::Load load;
  if (chosen.analysis == nullptr) return load;
  load.kind = KindOf(spec, chosen.name);
  load.iterates = Iterates(*chosen.analysis);
  load.effort = load.iterates > 0 ? load.iterates : work;
  load.seconds = SecondsOfIterate(spec.numerics().engine()) * CostOfWork(spec);
  return load;
}

}  // namespace

double CostOfWork(const v1::JobSpec& spec) {
  switch (spec.analysis_case()) {
    case v1::JobSpec::kSection:
      return 3;  // one orbit, which does not fill the lanes
    case v1::JobSpec::kHyperbolicity:
      return 7;
    case v1::JobSpec::kOrbit:
      return 1.3 * spec.orbit().step();  // an iterate takes some 0.8 units of time
    case v1::JobSpec::kFixedPoint:
      return spec.fixed_point().has_search() ? 1000 : 4000;
    case v1::JobSpec::kContinuation:
      return 250;
    case v1::JobSpec::kManifold:
      return 40'000;
    case v1::JobSpec::kSeparatrix:
      return 5000;
    case v1::JobSpec::kReproduce:
      return spec.reproduce().quick() ? 2e5 : 4e6;
    default:
      return 1;
  }
}

jobs::Load LoadOf(std::string_view specification, const jobs::Plan& plan) {
  v1::JobSpec spec;
  spec.ParseFromArray(specification.data(), static_cast<int>(specification.size()));
  jobs::Load load;
  if (spec.has_sweep()) {
    const SweepGrid grid(spec);
    load = LoadOf(grid.NodeSpec(0), NodeWork(grid.NodeSpec(0)));
    load.kind = "sweep/" + load.kind;
    load.iterates *= static_cast<double>(grid.nodes());
    load.effort *= static_cast<double>(grid.nodes());
  } else {
    load = LoadOf(spec, plan.work().total);
  }
  load.threads = std::max<std::int64_t>(plan.chains(), 1);
  if (TellsUnits(spec)) load.most_units = plan.chains() * plan.steps();
  return load;
}

}  // namespace celt::plans
