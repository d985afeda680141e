#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/time/time.h"

namespace celt::metrics {

/// What is counted only when somebody asks.
struct Snapshot {
  std::map<std::string, double> jobs;  ///< by state: "queued", "running", …
  double active_jobs = 0;              ///< in memory: running, or in the queue for a thread
  double streams = 0;                  ///< open
  double store_bytes = 0;
  double store_synchronous = 0;              ///< 1: normal, 2: full
  std::map<std::string, double> paces = {};  ///< by kind of job: seconds for an effort of 1
};

/// The numbers of a server, in Prometheus' format. Safe to use from many threads.
class Metrics {
 public:
  Metrics();
  ~Metrics();
  Metrics(const Metrics&) = delete;
  Metrics& operator=(const Metrics&) = delete;

  void CountCall(std::string_view method, absl::StatusCode code, absl::Duration took);
  /// A unit that was computed: how long it took, and what it did in the job's unit of work.
  void CountUnit(absl::Duration took, double work, std::string_view work_unit);
  void CountStoreError();

  /// The text format, version 0.0.4.
  std::string Text(const Snapshot& snapshot);

 private:
  struct Families;
  std::unique_ptr<Families> families_;
};

}  // namespace celt::metrics
