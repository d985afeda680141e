#pragma once

#include "absl/status/status.h"
#include "server/jobs/database.h"
#include "server/jobs/store.h"

namespace celt::jobs {

/// Makes the database a job store of the schema that this program knows: fills an empty one,
/// migrates an older one. FAILED_PRECONDITION: the file belongs to another program, or a newer celt
/// wrote it. DATA_LOSS: it is corrupt or no database. On error nothing was written.
absl::Status PrepareSchema(Database& database, Synchronous synchronous = Synchronous::kNormal);

}  // namespace celt::jobs
