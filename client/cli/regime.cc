#include "client/cli/regime.h"

namespace celt::cli {

std::string RegimeName(v1::Regime regime) {
  switch (regime) {
    case v1::REGIME_PERIODIC:
      return "periodic";
    case v1::REGIME_INVARIANT_CURVE:
      return "invariant curve";
    case v1::REGIME_CHAOS:
      return "chaos";
    case v1::REGIME_PSEUDO_HYPERBOLIC_CANDIDATE:
      return "pseudo-hyperbolic candidate";
    default:
      return "not told";
  }
}

}  // namespace celt::cli
