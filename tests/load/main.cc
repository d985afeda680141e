// celt_load: loads a celtd of its own and prints what came of it; exit code 1 when something went
// wrong. celt_load [CLIENTS [JOBS-EACH]]

#include <cstdio>
#include <cstdlib>

#include "tests/load/load.h"

int main(int argc, char** argv) {
  celt::load::Options options;
  if (argc > 1) options.clients = std::atoi(argv[1]);
  if (argc > 2) options.jobs_each = std::atoi(argv[2]);
  const celt::load::Report report = celt::load::Run(options);
  std::printf("%s", celt::load::Text(report).c_str());
  return report.errors + report.lost_records == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
