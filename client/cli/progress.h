#pragma once

#include <optional>
#include <string>

#include "absl/time/time.h"
#include "celt/v1/job.pb.h"

namespace celt::cli {

/// Makes the progress line of a job from what is known of it and when it was known.
class ProgressMeter {
 public:
  /// "[#####-----]  52%  4 100 iterates/s  0:12 left"; the rate over the last seconds. The times
  /// of successive calls must not decrease.
  std::string Line(const v1::Job& job, absl::Time now);

 private:
  std::optional<double> Rate(double done, absl::Time now);

  std::optional<absl::Time> since_;  ///< of the last measurement that entered the rate
  double done_ = 0;
  std::optional<double> rate_;  ///< per second, smoothed
};

}  // namespace celt::cli
