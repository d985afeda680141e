#include "server/api/info.h"

#include <string>

#include "absl/time/time.h"
#include "core/map/system.h"
#include "server/plans/engine_version.h"

namespace celt::api {
namespace {

void FillParameter(const ParameterInfo& from, v1::ParameterInfo& to) {
  to.set_name(std::string(from.name));
  to.set_default_value(from.default_value);
  to.set_unit(std::string(from.unit));
  to.set_description(std::string(from.description));
  to.set_range(RangeText(from));
}

void FillSystem(const System& from, v1::SystemInfo& to) {
  to.set_name(std::string(from.name()));
  to.set_description(std::string(from.description()));
  for (const ParameterInfo& parameter : from.parameters()) {
    FillParameter(parameter, *to.add_parameters());
  }
  for (const std::string_view name : from.coordinates()) to.add_coordinates(std::string(name));
}

void FillAnalyses(v1::GetInfoResponse& info) {
  const auto* const analyses = v1::JobSpec::descriptor()->FindOneofByName("analysis");
  for (int i = 0; i < analyses->field_count(); ++i) info.add_analyses(analyses->field(i)->name());
}

void FillEngines(v1::GetInfoResponse& info) {
  const auto* const engines = v1::Engine_descriptor();
  for (int i = 0; i < engines->value_count(); ++i) {
    const auto engine = static_cast<v1::Engine>(engines->value(i)->number());
    if (engine != v1::ENGINE_UNSPECIFIED) info.add_engines(engine);
  }
}

/// 0 tells that there is none.
std::int64_t LimitOf(std::int64_t limit) { return limit == jobs::JobLimits::kNone ? 0 : limit; }

void FillLimits(const plans::SpecLimits& specs, const jobs::JobLimits& jobs, v1::Limits& limits) {
  limits.set_iterates(LimitOf(specs.iterates));
  limits.set_nodes(LimitOf(specs.nodes));
  limits.set_records(LimitOf(jobs.records));
  if (jobs.computing_time != absl::InfiniteDuration()) {
    limits.set_computing_seconds(absl::ToDoubleSeconds(jobs.computing_time));
  }
  limits.set_unfinished_jobs(LimitOf(jobs.unfinished));
  limits.set_unfinished_jobs_per_owner(LimitOf(jobs.unfinished_per_owner));
}

}  // namespace

v1::GetInfoResponse MakeInfo(int workers, const plans::SpecLimits& specs,
                             const jobs::JobLimits& jobs) {
  v1::GetInfoResponse info;
  info.set_version(CELT_VERSION);
  info.set_workers(workers);
  info.set_engine_version(plans::kEngineVersion);
  for (const System* system : AllSystems()) FillSystem(*system, *info.add_systems());
  FillAnalyses(info);
  FillEngines(info);
  FillLimits(specs, jobs, *info.mutable_limits());
  return info;
}

}  // namespace celt::api
