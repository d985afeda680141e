#include "server/metrics/metrics.h"

#include "prometheus/counter.h"
#include "prometheus/family.h"
#include "prometheus/gauge.h"
#include "prometheus/histogram.h"
#include "prometheus/registry.h"
#include "prometheus/text_serializer.h"

namespace celt::metrics {
namespace {

using prometheus::Counter;
using prometheus::Family;
using prometheus::Gauge;
using prometheus::Histogram;

/// From a tenth of a millisecond to a minute.
const Histogram::BucketBoundaries& SecondsBuckets() {
  static const Histogram::BucketBoundaries buckets = {1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2,
                                                      0.1,  0.3,  1,    3,    10,   60};
  return buckets;
}

}  // namespace

struct Metrics::Families {
  prometheus::Registry registry;
  Family<Counter>& calls = prometheus::BuildCounter()
                               .Name("celt_calls_total")
                               .Help("Calls that have ended, by method and status code")
                               .Register(registry);
  Family<Histogram>& call_seconds = prometheus::BuildHistogram()
                                        .Name("celt_call_seconds")
                                        .Help("How long calls with one answer took")
                                        .Register(registry);
  Family<Histogram>& unit_seconds = prometheus::BuildHistogram()
                                        .Name("celt_unit_seconds")
                                        .Help("How long work units computed")
                                        .Register(registry);
  Family<Counter>& work = prometheus::BuildCounter()
                              .Name("celt_work_total")
                              .Help("Work done, by its unit: its rate is the engine's")
                              .Register(registry);
  Family<Counter>& store_errors = prometheus::BuildCounter()
                                      .Name("celt_store_errors_total")
                                      .Help("Writes that the job store did not take")
                                      .Register(registry);
  Family<Gauge>& jobs =
      prometheus::BuildGauge().Name("celt_jobs").Help("Jobs, by state").Register(registry);
  Family<Gauge>& active = prometheus::BuildGauge()
                              .Name("celt_active_jobs")
                              .Help("Jobs that run or wait for a thread")
                              .Register(registry);
  Family<Gauge>& streams =
      prometheus::BuildGauge().Name("celt_streams").Help("Open streams").Register(registry);
  Family<Gauge>& store_bytes = prometheus::BuildGauge()
                                   .Name("celt_store_bytes")
                                   .Help("Size of what is in the job store")
                                   .Register(registry);
  Family<Gauge>& store_synchronous =
      prometheus::BuildGauge()
          .Name("celt_store_synchronous")
          .Help("What survives a power cut: 1, all but the last commits; 2, all")
          .Register(registry);
  Family<Gauge>& paces = prometheus::BuildGauge()
                             .Name("celt_pace_seconds")
                             .Help(
                                 "What a thread lately took for an iterate, or else for a unit of "
                                 "work, by kind of job: what estimates go by")
                             .Register(registry);
};

Metrics::Metrics() : families_(std::make_unique<Families>()) {
  families_->store_errors.Add({});  // there from the start, so that its rate is
}
Metrics::~Metrics() = default;

void Metrics::CountCall(std::string_view method, absl::StatusCode code, absl::Duration took) {
  const std::string name(method);
  families_->calls.Add({{"method", name}, {"code", absl::StatusCodeToString(code)}}).Increment();
  families_->call_seconds.Add({{"method", name}}, SecondsBuckets())
      .Observe(absl::ToDoubleSeconds(took));
}

void Metrics::CountUnit(absl::Duration took, double work, std::string_view work_unit) {
  families_->unit_seconds.Add({}, SecondsBuckets()).Observe(absl::ToDoubleSeconds(took));
  families_->work.Add({{"unit", std::string(work_unit)}}).Increment(work);
}

void Metrics::CountStoreError() { families_->store_errors.Add({}).Increment(); }

std::string Metrics::Text(const Snapshot& snapshot) {
  for (const auto& [state, count] : snapshot.jobs) {
    families_->jobs.Add({{"state", state}}).Set(count);
  }
  families_->active.Add({}).Set(snapshot.active_jobs);
  families_->streams.Add({}).Set(snapshot.streams);
  families_->store_bytes.Add({}).Set(snapshot.store_bytes);
  families_->store_synchronous.Add({}).Set(snapshot.store_synchronous);
  for (const auto& [kind, pace] : snapshot.paces) families_->paces.Add({{"kind", kind}}).Set(pace);
  return prometheus::TextSerializer().Serialize(families_->registry.Collect());
}

}  // namespace celt::metrics
