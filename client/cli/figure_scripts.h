#pragma once

#include <string>
#include <vector>

namespace celt::cli {

// Scripts for gnuplot. Each reads NAME.csv files that stand beside it and makes NAME.png.

/// A panel of a figure: points of the section, in the plane in which the attractor shows its wings.
struct Panel {
  std::string title;
  std::string points;    ///< NAME of iterates; empty: none
  std::string manifold;  ///< NAME of an unstable manifold; empty: none
};

/// Panels side by side, so many to a row.
std::string PanelsScript(const std::string& name, const std::vector<Panel>& panels, int columns);

/// The stone's attractor beside that of the Lorenz flow.
std::string LorenzScript(const std::string& name, const std::string& attractor,
                         const std::string& lorenz);

/// The largest exponent, with its error, along an axis of energy.
std::string ExponentScript(const std::string& name, const std::string& sweep);

/// Pairs of an LMP graph, one file to a panel.
std::string LmpScript(const std::string& name, const std::vector<Panel>& panels);

/// The section's l along an axis of energy.
std::string BifurcationScript(const std::string& name, const std::string& points);

}  // namespace celt::cli
