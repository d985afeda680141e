#pragma once

#include <chrono>
#include <string>

namespace celt::load {

struct Options {
  int clients = 200;  ///< each submits small jobs and reads their streams, one after the other
  int jobs_each = 5;
  int stalled = 50;   ///< readers that read one record of a large stream and no more
  int dropped = 500;  ///< streams that one client opens and drops
  int timed = 30;     ///< small jobs that one client asks for beside the sweep, for the median
};

struct Report {
  int jobs = 0;               ///< small ones that were answered
  int errors = 0;             ///< calls and streams that ended otherwise than they should
  int lost_records = 0;       ///< streams whose bytes were not those of the first
  double seconds = 0;         ///< of the crowd
  double peak_megabytes = 0;  ///< resident, of the server
  double alone_ms = 0;        ///< median of a small job's answer on an idle server
  double beside_ms = 0;       ///< the same beside a sweep
  std::string first_error;
};

/// Starts a server of two workers and loads it: a sweep that outlasts everything, stalled readers,
/// a crowd of clients with small jobs, and one that opens and drops streams.
Report Run(const Options& options);

std::string Text(const Report& report);

}  // namespace celt::load
