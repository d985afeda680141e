#pragma once

#include <string>
#include <vector>

#include "celt/v1/system.pb.h"
#include "client/cli/analysis.h"

namespace celt::cli {

/// Names of a point's coordinates, as columns: l, l_over_g, h_over_g of the stone, else x_1, x_2
/// ...
std::vector<std::string> CoordinateColumns(const v1::Point& point);

/// The same for people: l, L/G, H/G, else x1, x2 ...
std::vector<std::string> CoordinateTitles(const v1::Point& point);

/// The coordinates, in the same order.
std::vector<double> Coordinates(const v1::Point& point);

/// One cell for each coordinate, with all digits.
void AddPoint(const v1::Point& point, CsvRow& row);

/// "(2.147462, -0.669144, -0.384701)".
std::string PointText(const v1::Point& point);

/// A number of a column of text, so many decimals, padded on the left; apart from the column before
/// even where it is too long.
std::string Column(double number, int width, int decimals);

}  // namespace celt::cli
