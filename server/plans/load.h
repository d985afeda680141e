#pragma once

#include <string_view>

#include "celt/v1/job.pb.h"
#include "server/jobs/forecast.h"
#include "server/jobs/plan.h"

namespace celt::plans {

/// What a resolved specification (celt.v1.JobSpec, serialized) asks of a server: of a kind are jobs
/// of one analysis, system and engine, and the effort is counted in iterates where the
/// specification tells them.
jobs::Load LoadOf(std::string_view specification, const jobs::Plan& plan);

/// What a unit of the work of a plan costs, or an iterate where it counts those, in iterates with
/// tangents of one of many orbits: roughly, from the times of the commands' defaults.
double CostOfWork(const v1::JobSpec& spec);

}  // namespace celt::plans
