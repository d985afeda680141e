#pragma once

#include "absl/status/status.h"
#include "grpcpp/support/status.h"

namespace celt::api {

/// The same code and message, with google.rpc's details where there are any: the field that is
/// wrong, the job that is in the way, when to try again. A message too long for a header is cut.
/// The one place where statuses become gRPC's.
grpc::Status ToGrpc(const absl::Status& status);

}  // namespace celt::api
