#include "server/plans/reproduce_items.h"

namespace celt::plans {

std::span<const ReproduceItem> ReproduceItems() {
  static constexpr ReproduceItem kItems[] = {
      {"3.3, 1", "the saddle O*", FixedPointRows},
      {"3.3, 2", "the exponents at E = 752", SpectrumRows},
      {"3.3, 3", "Λ1 on [752, 752.01]", GraphRows},
      {"3.1", "pseudo-hyperbolicity", HyperbolicityRows},
      {"3.3, 4", "E1 and E4", BifurcationRows},
      {"3.3, 4", "E2", ButterflyRows},
      {"3.3, 4", "E3", BasinRows},
      {"Fig. 5", "the stages of birth", BirthRows},
      {"Fig. 7", "the stages of destruction", DestructionRows},
      {"Fig. 7", "the breakdown", BreakdownRows},
  };
  return kItems;
}

}  // namespace celt::plans
