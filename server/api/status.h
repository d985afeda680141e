#pragma once

#include "absl/status/status.h"
#include "grpcpp/support/status.h"

namespace celt::api {

/// The same code and message; a message too long for a header is cut. The one place where statuses
/// become gRPC's.
grpc::Status ToGrpc(const absl::Status& status);

}  // namespace celt::api
