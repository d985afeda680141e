#pragma once

#include <string_view>

#include "server/jobs/forecast.h"
#include "server/jobs/plan.h"

namespace celt::plans {

/// What a resolved specification (celt.v1.JobSpec, serialized) asks of a server: of a kind are jobs
/// of one analysis, system and engine, and the effort is counted in iterates where the
/// specification tells them.
jobs::Load LoadOf(std::string_view specification, const jobs::Plan& plan);

}  // namespace celt::plans
