#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "absl/time/time.h"

namespace celt::jobs {

/// What a job asks of a server, as far as that can be told before it computes.
struct Load {
  std::string kind;             ///< jobs of one kind take about equally long for the same effort
  double effort = 0;            ///< of the whole job, in its kind's own measure
  double seconds = 0;           ///< of one thread for an effort of 1, as long as none was measured
  std::int64_t threads = 1;     ///< that it can keep busy
  std::int64_t most_units = 0;  ///< 0: their number shows only as it goes
  double iterates = 0;          ///< of the section map; 0: as above
};

/// What is left of a job is expected to take. Nothing of it enters an answer.
struct Estimate {
  std::int64_t most_units = 0;  ///< of the whole job
  double iterates = 0;          ///< of the whole job
  absl::Duration alone;         ///< when the job has all threads to itself
  absl::Duration queue;         ///< what is left of all other jobs, over all threads
};

/// Foretells how long jobs take, from how long units of their kind took lately. Safe to use from
/// many threads.
class Forecast {
 public:
  explicit Forecast(int workers) : workers_(workers) {}

  /// A job of which `share` in [0, 1] is done is to be computed.
  void Begin(std::string_view id, const Load& load, double share);
  /// A unit of it is done: this share of the job, in this time. Nothing happens to a job that was
  /// not begun.
  void CountUnit(std::string_view id, double share, absl::Duration took);
  /// It is not computed any more.
  void End(std::string_view id);
  /// What an earlier job took, all of it, on one thread.
  void Learn(const Load& load, absl::Duration took);

  /// Nothing when the job was not begun.
  std::optional<Estimate> Of(std::string_view id) const;
  /// Of a job that might be begun now.
  Estimate Of(const Load& load) const;
  /// Seconds of one thread for an effort of 1, by kind; only what was measured.
  std::map<std::string, double> Paces() const;

 private:
  struct Kind {
    double prior = 0;    ///< seconds for an effort of 1
    double effort = 0;   ///< lately, with
    double seconds = 0;  ///< these
    double left = 0;     ///< effort, of all jobs
    double Pace() const { return effort > 0 ? seconds / effort : prior; }
    void Measure(double new_effort, absl::Duration took);
  };
  struct Job {
    Load load;
    double left = 0;  ///< effort
  };

  Estimate Of(const Load& load, double left, double own) const;

  const int workers_;
  mutable std::mutex mutex_;
  std::map<std::string, Kind, std::less<>> kinds_;
  std::map<std::string, Job, std::less<>> jobs_;
};

}  // namespace celt::jobs
