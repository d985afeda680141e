#pragma once

#include <memory>

#include "absl/status/statusor.h"
#include "grpcpp/security/server_credentials.h"
#include "server/host/host.h"

namespace celt::host {

/// With a certificate, TLS; client certificates are asked for where their authorities are named,
/// and required unless tokens do as well. INVALID_ARGUMENT names the file that can't be read.
absl::StatusOr<std::shared_ptr<grpc::ServerCredentials>> CredentialsOf(const Keys& keys);

}  // namespace celt::host
