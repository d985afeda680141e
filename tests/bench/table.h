#pragma once

#include <map>
#include <string>
#include <vector>

#include "benchmark/benchmark.h"

namespace celt::bench {

/// Shows runs as they end, and keeps the rates of each. What counts is the median over its
/// repetitions: deploy/bench takes these in random order, so that the slow and the fast phases of a
/// machine that is shared come to all alike.
class Collector final : public benchmark::ConsoleReporter {
 public:
  Collector() : ConsoleReporter(OO_None) {}
  void ReportRuns(const std::vector<Run>& runs) override;
  /// Items a second by the benchmark's name; 0 when it was not run.
  double Rate(const std::string& name) const;

 private:
  std::map<std::string, std::vector<double>> rates_;
};

/// The comparison as Markdown: each tool at the fastest tolerance that is accurate enough, with
/// ratios to Boost.odeint.
std::string Table(const Collector& runs);

}  // namespace celt::bench
