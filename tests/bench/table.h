#pragma once

#include <map>
#include <string>
#include <vector>

#include "benchmark/benchmark.h"

namespace celt::bench {

/// Shows runs as they end, and keeps the best rate of each, over its repetitions: whatever else the
/// machine does can only slow a run down.
class Collector final : public benchmark::ConsoleReporter {
 public:
  Collector() : ConsoleReporter(OO_None) {}
  void ReportRuns(const std::vector<Run>& runs) override;
  /// Items a second by the benchmark's name; 0 when it was not run.
  double Rate(const std::string& name) const;

 private:
  std::map<std::string, double> rates_;
};

/// The comparison as Markdown: each tool at the fastest tolerance that is accurate enough, with
/// ratios to Boost.odeint.
std::string Table(const Collector& runs);

}  // namespace celt::bench
