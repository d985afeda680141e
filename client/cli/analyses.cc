#include "client/cli/analysis.h"
#include "client/cli/continuation.h"
#include "client/cli/fixed_point.h"
#include "client/cli/hyperbolicity.h"
#include "client/cli/lyapunov.h"
#include "client/cli/manifold.h"
#include "client/cli/orbit.h"
#include "client/cli/reproduce.h"
#include "client/cli/section.h"
#include "client/cli/separatrix.h"
#include "client/cli/sweep.h"

namespace celt::cli {

Analyses MakeAnalyses() {
  Analyses analyses;
  analyses.push_back(MakeLyapunov());
  analyses.push_back(MakeSection());
  analyses.push_back(MakeSweep());
  analyses.push_back(MakeFixedPoint());
  analyses.push_back(MakeContinuation());
  analyses.push_back(MakeOrbit());
  analyses.push_back(MakeReproduce());
  analyses.push_back(MakeManifold());
  analyses.push_back(MakeHyperbolicity());
  analyses.push_back(MakeSeparatrix());
  return analyses;
}

}  // namespace celt::cli
