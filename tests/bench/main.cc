// Measures, shows each run on stderr, and prints the table that the README carries on stdout.
#include <iostream>

#include "benchmark/benchmark.h"
#include "tests/bench/section_bench.h"
#include "tests/bench/table.h"

int main(int argc, char** argv) {
  celt::bench::RegisterSectionBenches();
  celt::bench::RegisterServiceBenches();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  celt::bench::Collector runs;
  runs.SetOutputStream(&std::cerr);
  runs.SetErrorStream(&std::cerr);
  benchmark::RunSpecifiedBenchmarks(&runs);
  std::cout << celt::bench::Table(runs);
  return 0;
}
