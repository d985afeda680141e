#pragma once

#include <memory>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "core/map/system.h"
#include "server/jobs/plan.h"

namespace celt::plans {

/// An analysis that the service offers. A new one is a file that defines these two functions, and a
/// line in analysis.cc.
struct Analysis {
  /// Fills in the defaults of its own part of a specification in which everything else is resolved,
  /// and checks it as far as that can be done without computing. INVALID_ARGUMENT names the field.
  absl::Status (*resolve)(const System& system, v1::JobSpec& spec);
  /// The plan of a resolved specification.
  absl::StatusOr<std::unique_ptr<jobs::Plan>> (*make_plan)(const v1::JobSpec& resolved);
  /// Numerics.tolerance where none is given.
  double tolerance = Numerics().tolerance;
};

/// The analysis that a specification asks for. INVALID_ARGUMENT when it asks for none.
absl::StatusOr<Analysis> FindAnalysis(const v1::JobSpec& spec);

}  // namespace celt::plans
