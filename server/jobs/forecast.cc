#include "server/jobs/forecast.h"

#include <algorithm>

namespace celt::jobs {

/// Averages over the last units, some tens of them: what ran beside them may have changed.
void Forecast::Kind::Measure(double new_effort, absl::Duration took) {
  constexpr double kMemory = 0.95;
  effort = kMemory * effort + new_effort;
  seconds = kMemory * seconds + absl::ToDoubleSeconds(took);
}

void Forecast::Begin(std::string_view id, const Load& load, double share) {
  const std::lock_guard lock(mutex_);
  const double left = load.effort * std::clamp(1 - share, 0.0, 1.0);
  if (!jobs_.emplace(id, Job{load, left}).second) return;
  Kind& kind = kinds_[load.kind];
  kind.prior = load.seconds;
  kind.left += left;
}

void Forecast::CountUnit(std::string_view id, double share, absl::Duration took) {
  const std::lock_guard lock(mutex_);
  const auto found = jobs_.find(id);
  if (found == jobs_.end()) return;
  Job& job = found->second;
  Kind& kind = kinds_[job.load.kind];
  const double effort = share * job.load.effort;
  kind.Measure(effort, took);
  const double done = std::min(effort, job.left);
  job.left -= done;
  kind.left -= done;
}

void Forecast::End(std::string_view id) {
  const std::lock_guard lock(mutex_);
  const auto found = jobs_.find(id);
  if (found == jobs_.end()) return;
  kinds_[found->second.load.kind].left -= found->second.left;
  jobs_.erase(found);
  if (!jobs_.empty()) return;
  for (auto& [name, kind] : kinds_) kind.left = 0;  // but for rounding, it is
}

void Forecast::Learn(const Load& load, absl::Duration took) {
  const std::lock_guard lock(mutex_);
  kinds_[load.kind].Measure(load.effort, took);
}

std::optional<Estimate> Forecast::Of(std::string_view id) const {
  const std::lock_guard lock(mutex_);
  const auto found = jobs_.find(id);
  if (found == jobs_.end()) return std::nullopt;
  return Of(found->second.load, found->second.left, found->second.left);
}

Estimate Forecast::Of(const Load& load) const {
  const std::lock_guard lock(mutex_);
  return Of(load, load.effort, 0);
}

/// Under mutex_. `own`: what the queue has of this job.
Estimate Forecast::Of(const Load& load, double left, double own) const {
  const auto kind = kinds_.find(load.kind);
  const bool measured = kind != kinds_.end() && kind->second.effort > 0;
  const double pace = measured ? kind->second.Pace() : load.seconds;
  double queue = 0;
  for (const auto& [name, other] : kinds_) queue += other.left * other.Pace();
  queue = std::max(0.0, queue - own * pace);
  const auto threads = std::clamp<std::int64_t>(load.threads, 1, workers_);
  Estimate estimate;
  estimate.most_units = load.most_units;
  estimate.iterates = load.iterates;
  estimate.alone = absl::Seconds(left * pace / static_cast<double>(threads));
  estimate.queue = absl::Seconds(queue / workers_);
  return estimate;
}

std::map<std::string, double> Forecast::Paces() const {
  const std::lock_guard lock(mutex_);
  std::map<std::string, double> paces;
  for (const auto& [name, kind] : kinds_) {
    if (kind.effort > 0) paces[name] = kind.Pace();
  }
  return paces;
}

}  // namespace celt::jobs
