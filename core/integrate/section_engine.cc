#include "core/integrate/section_engine.h"

#include "absl/status/status.h"
#include "core/integrate/fast/fast_section_engine.h"
#include "core/integrate/sundials_section_engine.h"

namespace celt {

absl::StatusOr<std::unique_ptr<SectionEngine>> MakeSectionEngine(const CelticStone& stone,
                                                                 const SectionEvent& section,
                                                                 const Numerics& numerics) {
  const auto make = [&](SteppingMethod method) {
    return std::make_unique<SundialsSectionEngine>(stone, section, method, numerics.tolerance);
  };
  switch (numerics.engine) {
    case Engine::kArkode:
      return make(SteppingMethod::kRungeKutta);
    case Engine::kCvode:
      return make(SteppingMethod::kAdams);
    case Engine::kDefault:
    case Engine::kFast:
      return std::make_unique<FastSectionEngine>(stone, section, numerics.tolerance);
  }
  return absl::InternalError("engine: unknown");
}

}  // namespace celt
