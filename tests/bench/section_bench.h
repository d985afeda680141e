#pragma once

#include <string>

#include "core/map/map.h"
#include "tests/bench/tool.h"

namespace celt::bench {

/// "fast/1e-11/jacobian/64": a tool, with tangents or ("map") without, and how many orbits at once.
std::string SectionBenchName(const Tool& tool, Derivative derivative, int orbits);
/// Errors of a tool, computed once.
const Errors& ErrorsOfTool(const Tool& tool);

/// Iterates of the section map, by every tool; items are iterates.
void RegisterSectionBenches();
/// The same on several cores; a job beside its engine alone; a chart.
void RegisterServiceBenches();

}  // namespace celt::bench
