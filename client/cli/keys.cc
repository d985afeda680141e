#include "client/cli/keys.h"

#include <fstream>
#include <optional>
#include <sstream>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"

namespace celt::cli {
namespace {

absl::StatusOr<std::string> ReadFile(const char* option, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream contents;
  contents << file.rdbuf();
  if (file) return contents.str();
  return absl::InvalidArgumentError(absl::StrCat(option, ": '", path, "' can't be read"));
}

absl::Status Read(const char* option, const std::optional<std::string>& path, std::string& to) {
  if (!path) return absl::OkStatus();
  auto contents = ReadFile(option, *path);
  if (!contents.ok()) return contents.status();
  to = *std::move(contents);
  return absl::OkStatus();
}

bool IsLoopback(const std::string& address) {
  return address.starts_with("127.") || address.starts_with("localhost:") ||
         address.starts_with("[::1]:");
}

absl::StatusOr<std::string> FindToken(const ServiceOptions& options,
                                      const Environment& environment) {
  std::string path = options.token_file.value_or(environment.token_file);
  if (path.empty()) return environment.token;
  const char* const name = options.token_file ? "--token-file" : "CELT_TOKEN_FILE";
  auto token = ReadFile(name, path);
  if (token.ok()) absl::StripAsciiWhitespace(&*token);
  return token;
}

}  // namespace

absl::StatusOr<client::ChannelSecurity> SecurityOf(const ServiceOptions& options,
                                                   const Environment& environment) {
  client::ChannelSecurity security;
  std::optional<std::string> authorities = options.tls_ca;
  if (!authorities && !environment.tls_ca.empty()) authorities = environment.tls_ca;
  security.tls = options.tls || authorities || options.tls_certificate;
  if (options.tls_certificate.has_value() != options.tls_key.has_value()) {
    return absl::InvalidArgumentError("--tls-key: goes with --tls-certificate; give both or none");
  }
  absl::Status status = Read("--tls-ca", authorities, security.authorities);
  if (status.ok())
    status = Read("--tls-certificate", options.tls_certificate, security.certificate);
  if (status.ok()) status = Read("--tls-key", options.tls_key, security.key);
  if (!status.ok()) return status;
  return security;
}

absl::StatusOr<std::string> TokenFor(const std::string& address,
                                     const client::ChannelSecurity& security,
                                     const ServiceOptions& options,
                                     const Environment& environment) {
  auto token = FindToken(options, environment);
  if (!token.ok() || token->empty() || security.tls || IsLoopback(address)) return token;
  return absl::InvalidArgumentError(absl::StrCat("--server: a token does not travel in clear to ",
                                                 address, "; encrypt with --tls or --tls-ca"));
}

}  // namespace celt::cli
