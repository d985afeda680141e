// celt_load: loads a celtd of its own and prints what came of it; exit code 1 when something went
// wrong, the server took too much memory, or a small job waited too long beside a sweep. celt_load
// [CLIENTS [JOBS-EACH]]

#include <cstdio>
#include <cstdlib>

#include "tests/load/load.h"

namespace {

/// What a server promises; times on a machine that has nothing else to do.
bool IsKept(const celt::load::Report& report) {
  constexpr double kMegabytes = 200;
  constexpr double kTimes = 2;
  constexpr double kMilliseconds = 50;
  return report.errors + report.lost_records == 0 && report.peak_megabytes < kMegabytes &&
         report.beside_ms < kTimes * report.alone_ms + kMilliseconds;
}

}  // namespace

int main(int argc, char** argv) {
  celt::load::Options options;
  if (argc > 1) options.clients = std::atoi(argv[1]);
  if (argc > 2) options.jobs_each = std::atoi(argv[2]);
  const celt::load::Report report = celt::load::Run(options);
  std::printf("%s", celt::load::Text(report).c_str());
  return IsKept(report) ? EXIT_SUCCESS : EXIT_FAILURE;
}
