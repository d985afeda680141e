#include "client/cli/analysis.h"
#include "client/cli/lyapunov.h"
#include "client/cli/section.h"

namespace celt::cli {

Analyses MakeAnalyses() {
  Analyses analyses;
  analyses.push_back(MakeLyapunov());
  analyses.push_back(MakeSection());
  return analyses;
}

}  // namespace celt::cli
