#include "client/cli/progress.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/cli/format.h"

namespace celt::cli {
namespace {

std::string Bar(double fraction) {
  constexpr int kWidth = 24;
  const int full = static_cast<int>(fraction * kWidth);
  return absl::StrCat("[", std::string(static_cast<std::size_t>(full), '#'),
                      std::string(static_cast<std::size_t>(kWidth - full), '-'), "]");
}

std::string RateText(double rate) {
  constexpr double kWhole = 100;
  return rate < kWhole ? Significant(rate, 2) : Grouped(std::llround(rate));
}

}  // namespace

std::optional<double> ProgressMeter::Rate(double done, absl::Time now) {
  constexpr double kMemory = 3;  // seconds, about which the rate is averaged
  if (!since_ || done < done_) {
    since_ = now;
    done_ = done;
    return rate_;
  }
  const double passed = absl::ToDoubleSeconds(now - *since_);
  if (passed <= 0 || (done <= done_ && passed < kMemory)) return rate_;
  const double latest = (done - done_) / passed;
  const double weight = -std::expm1(-passed / kMemory);
  rate_ = rate_ ? *rate_ + weight * (latest - *rate_) : latest;
  since_ = now;
  done_ = done;
  return rate_;
}

std::string ProgressMeter::Line(const v1::Job& job, absl::Time now) {
  if (job.state() == v1::Job::STATE_QUEUED) return "waiting for a worker";
  const v1::Progress& progress = job.progress();
  const auto rate = Rate(progress.done(), now);
  const double fraction =
      progress.total() > 0 ? std::clamp(progress.done() / progress.total(), 0.0, 1.0) : 0;
  std::string line =
      absl::StrFormat("%s %3d%%", Bar(fraction), static_cast<int>(std::floor(100 * fraction)));
  if (!rate || !(*rate > 0)) return line;
  absl::StrAppend(&line, "  ", RateText(*rate), " ", progress.unit(), "/s");
  const double left = (progress.total() - progress.done()) / *rate;
  absl::StrAppend(&line, "  ", Clock(absl::Seconds(std::max(left, 0.0))), " left");
  return line;
}

}  // namespace celt::cli
