#include "server/host/credentials.h"

#include <optional>
#include <string>

#include "grpc/grpc.h"
#include "grpc/grpc_security.h"

namespace celt::host {
namespace {

/// What gRPC asks at every new connection.
grpc_ssl_certificate_config_reload_status Fetch(void* files,
                                                grpc_ssl_server_certificate_config** config) {
  const std::optional<Certificates> latest = static_cast<CertificateFiles*>(files)->Take();
  if (!latest) return GRPC_SSL_CERTIFICATE_CONFIG_RELOAD_UNCHANGED;
  const grpc_ssl_pem_key_cert_pair pair = {latest->key.c_str(), latest->chain.c_str()};
  // gRPC insists on authorities; where clients are not asked for certificates, it uses none.
  const std::string& authorities =
      latest->client_authorities.empty() ? latest->chain : latest->client_authorities;
  *config = grpc_ssl_server_certificate_config_create(authorities.c_str(), &pair, 1);
  return GRPC_SSL_CERTIFICATE_CONFIG_RELOAD_NEW;
}

grpc_ssl_client_certificate_request_type RequestOf(ClientCertificates clients) {
  switch (clients) {
    case ClientCertificates::kWelcome:
      return GRPC_SSL_REQUEST_CLIENT_CERTIFICATE_AND_VERIFY;
    case ClientCertificates::kRequired:
      return GRPC_SSL_REQUEST_AND_REQUIRE_CLIENT_CERTIFICATE_AND_VERIFY;
    default:
      return GRPC_SSL_DONT_REQUEST_CLIENT_CERTIFICATE;
  }
}

/// gRPC's C++ reads certificates again in an experimental part alone, in which we can't check them
/// first; its C asks us at every connection.
class FetchedCredentials final : public grpc::ServerCredentials {
 public:
  FetchedCredentials(CertificateFiles& files, ClientCertificates clients)
      : credentials_(grpc_ssl_server_credentials_create_with_options(
            grpc_ssl_server_credentials_create_options_using_config_fetcher(RequestOf(clients),
                                                                            Fetch, &files))) {}
  ~FetchedCredentials() override { grpc_server_credentials_release(credentials_); }
  FetchedCredentials(const FetchedCredentials&) = delete;
  FetchedCredentials& operator=(const FetchedCredentials&) = delete;

  /// For metadata that a credential would check; ours is checked with the call.
  void SetAuthMetadataProcessor(
      const std::shared_ptr<grpc::AuthMetadataProcessor>& /*processor*/) override {}

 private:
  int AddPortToServer(const std::string& address, grpc_server* server) override {
    return grpc_server_add_http2_port(server, address.c_str(), credentials_);
  }

  grpc_server_credentials* const credentials_;
};

}  // namespace

std::shared_ptr<grpc::ServerCredentials> TlsCredentials(CertificateFiles& files,
                                                        ClientCertificates clients) {
  return std::make_shared<FetchedCredentials>(files, clients);
}

}  // namespace celt::host
