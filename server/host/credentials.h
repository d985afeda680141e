#pragma once

#include <memory>

#include "grpcpp/security/server_credentials.h"
#include "server/host/certificates.h"

namespace celt::host {

/// Whether TLS asks clients for certificates.
enum class ClientCertificates { kNone, kWelcome, kRequired };

/// TLS with these certificates: each new connection gets the latest. `files` must outlive the
/// server.
std::shared_ptr<grpc::ServerCredentials> TlsCredentials(CertificateFiles& files,
                                                        ClientCertificates clients);

}  // namespace celt::host
