#pragma once

namespace celt::bench {

/// Where an orbit is with respect to the section (section_event.h).
struct Place {
  double value;  ///< e: vanishes on the section
  double side;   ///< positive on the section, negative half a turn away from it
};

}  // namespace celt::bench
