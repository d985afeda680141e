#include "server/host/credentials.h"

#include <fstream>
#include <sstream>
#include <string>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"

namespace celt::host {
namespace {

absl::StatusOr<std::string> ReadPem(const std::string& setting, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream contents;
  contents << file.rdbuf();
  if (file && contents.str().find("-----BEGIN ") != std::string::npos) return contents.str();
  return absl::InvalidArgumentError(
      absl::StrCat(setting, ": ", path, " can't be read, or is no PEM file"));
}

}  // namespace

absl::StatusOr<std::shared_ptr<grpc::ServerCredentials>> CredentialsOf(const Keys& keys) {
  if (keys.certificate.empty()) return grpc::InsecureServerCredentials();
  grpc::SslServerCredentialsOptions options(GRPC_SSL_DONT_REQUEST_CLIENT_CERTIFICATE);
  grpc::SslServerCredentialsOptions::PemKeyCertPair pair;
  CELT_ASSIGN_OR_RETURN(pair.private_key, ReadPem("access.key", keys.key));
  CELT_ASSIGN_OR_RETURN(pair.cert_chain, ReadPem("access.certificate", keys.certificate));
  options.pem_key_cert_pairs.push_back(std::move(pair));
  if (!keys.client_ca.empty()) {
    CELT_ASSIGN_OR_RETURN(options.pem_root_certs, ReadPem("access.client_ca", keys.client_ca));
    options.client_certificate_request =
        keys.tokens.empty() ? GRPC_SSL_REQUEST_AND_REQUIRE_CLIENT_CERTIFICATE_AND_VERIFY
                            : GRPC_SSL_REQUEST_CLIENT_CERTIFICATE_AND_VERIFY;
  }
  return grpc::SslServerCredentials(options);
}

}  // namespace celt::host
