#include "client/cli/analysis.h"
#include "client/cli/lyapunov.h"

namespace celt::cli {

Analyses MakeAnalyses() {
  Analyses analyses;
  analyses.push_back(MakeLyapunov());
  return analyses;
}

}  // namespace celt::cli
