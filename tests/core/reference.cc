#include "tests/core/reference.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace celt {
namespace {

std::vector<std::string> Lines(const std::string& name) {
  std::ifstream file(std::string(CELT_REFERENCE_DIR) + "/" + name);
  if (!file) throw std::runtime_error("no reference file " + name);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// The numbers in a line, whatever stands between them.
std::vector<double> Numbers(std::string line) {
  // An E of a name would pass for the E of an exponent.
  for (std::size_t at; (at = line.find("\"E\"")) != std::string::npos;) line.erase(at, 3);
  std::ranges::replace_if(
      line, [](char c) { return std::string("0123456789.-+eE").find(c) == std::string::npos; },
      ' ');
  std::istringstream words(line);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    if (word.find_first_of("0123456789") != std::string::npos) numbers.push_back(std::stod(word));
  }
  return numbers;
}

}  // namespace

std::vector<ReferenceIterate> ReferenceIterates() {
  std::vector<ReferenceIterate> iterates;
  for (const std::string& line : Lines("section_map_752.csv")) {
    if (line.starts_with('#') || line.starts_with('M')) continue;
    const std::vector<double> numbers = Numbers(line);
    ReferenceIterate iterate;
    iterate.state = StoneState(numbers.data());
    iterate.point = Eigen::Vector3d(numbers.data() + 6);
    iterate.time = numbers.at(9);
    iterate.image = Eigen::Vector3d(numbers.data() + 10);
    iterate.jacobian = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>(numbers.data() + 13);
    iterates.push_back(iterate);
  }
  return iterates;
}

std::vector<ReferenceFixedPoint> ReferenceFixedPoints() {
  std::vector<ReferenceFixedPoint> points;
  for (const std::string& line : Lines("celtic_stone.json")) {
    if (line.find("\"multipliers\"") == std::string::npos) continue;
    const std::vector<double> numbers = Numbers(line);
    points.push_back({.energy = numbers.at(0),
                      .delta = numbers.at(1),
                      .point = Eigen::Vector3d(numbers.data() + 2),
                      .time = numbers.at(5),
                      .multipliers = Eigen::Vector3d(numbers.data() + 6)});
  }
  return points;
}

}  // namespace celt
