#pragma once

#include <string>

#include "celt/v1/cycle.pb.h"
#include "celt/v1/manifold.pb.h"
#include "celt/v1/system.pb.h"
#include "client/cli/analysis.h"

namespace celt::cli {

/// So many decimals; no sign before a number that is 0 to all of them.
std::string Decimals(double number, int decimals);

/// "0.9660613332", "0.9769050000 ± 0.2136730000 i" of the one with the positive imaginary part.
std::string MultiplierText(const v1::Multiplier& multiplier, int decimals);

/// All of a cycle on one line, of a complex pair one; "" when there are none.
std::string MultipliersText(const google::protobuf::RepeatedPtrField<v1::Multiplier>& multipliers,
                            int decimals);

/// The paper's test of a fixed point that may carry a discrete Lorenz attractor, an inequality a
/// line; "" when there is none.
std::string LorenzTestText(const v1::Cycle& cycle);

/// "✓" or "✗"; "" when there is no test.
std::string LorenzMark(const v1::Cycle& cycle);

/// Cells of a cycle: its first point, its type, return time, multipliers and residual.
void AddCycle(const v1::Cycle& cycle, CsvRow& row);

/// A side of a manifold: "+" or "−".
std::string SideText(int side);
/// What became of a separatrix, in words.
std::string FateText(const v1::SeparatrixFate& fate);

/// A line with the errors of the map, when they were measured, and one for each warning.
std::string AccuracyText(const v1::Accuracy& accuracy);

}  // namespace celt::cli
