#pragma once

#include "celt/v1/celt.pb.h"
#include "server/jobs/limits.h"
#include "server/plans/limits.h"

namespace celt::api {

/// What a server of so many threads and these limits is, and what it can do.
v1::GetInfoResponse MakeInfo(int workers, const plans::SpecLimits& specs,
                             const jobs::JobLimits& jobs);

}  // namespace celt::api
