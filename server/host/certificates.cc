#include "server/host/certificates.h"

#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <fstream>
#include <sstream>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/host/host.h"
#include "server/jobs/status_macros.h"

namespace celt::host {
namespace {

using Certificate = std::unique_ptr<X509, decltype(&X509_free)>;
using PrivateKey = std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)>;
using Reader = std::unique_ptr<BIO, decltype(&BIO_free)>;

absl::Status NotUsable(const std::string& setting, const std::string& path,
                       const std::string& why) {
  return absl::InvalidArgumentError(absl::StrCat(setting, ": ", path, " ", why));
}

absl::StatusOr<std::string> ReadFile(const std::string& setting, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream contents;
  contents << file.rdbuf();
  if (!file) return NotUsable(setting, path, "can't be read");
  return contents.str();
}

Reader ReaderOf(const std::string& pem) {
  return {BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())), BIO_free};
}

/// The first one; null when there is none.
Certificate CertificateOf(const std::string& pem) {
  return {PEM_read_bio_X509(ReaderOf(pem).get(), nullptr, nullptr, nullptr), X509_free};
}

/// A key that wants a password is none: there is nobody to ask.
PrivateKey KeyOf(const std::string& pem) {
  std::string no_password;
  return {PEM_read_bio_PrivateKey(ReaderOf(pem).get(), nullptr, nullptr, no_password.data()),
          EVP_PKEY_free};
}

}  // namespace

CertificateFiles::CertificateFiles(const Keys& keys, const auth::WatchOptions& options)
    : chain_path_(keys.certificate),
      key_path_(keys.key),
      authorities_path_(keys.client_ca),
      on_error_(options.on_error),
      files_({chain_path_, key_path_, authorities_path_}, options) {}

absl::StatusOr<std::unique_ptr<CertificateFiles>> CertificateFiles::Open(
    const Keys& keys, const auth::WatchOptions& options) {
  std::unique_ptr<CertificateFiles> files(new CertificateFiles(keys, options));
  CELT_ASSIGN_OR_RETURN(files->read_, files->Read());
  return files;
}

std::optional<Certificates> CertificateFiles::Take() {
  const std::lock_guard lock(mutex_);
  if (files_.Changed()) {
    absl::StatusOr<Certificates> read = Read();
    if (read.ok()) {
      read_ = *std::move(read);
    } else {
      on_error_(absl::Status(
          read.status().code(),
          absl::StrCat(read.status().message(), "; the certificate that was read before holds")));
    }
  }
  return std::exchange(read_, std::nullopt);
}

absl::StatusOr<Certificates> CertificateFiles::Read() const {
  Certificates read;
  CELT_ASSIGN_OR_RETURN(read.chain, ReadFile("access.certificate", chain_path_));
  CELT_ASSIGN_OR_RETURN(read.key, ReadFile("access.key", key_path_));
  ERR_clear_error();
  const Certificate certificate = CertificateOf(read.chain);
  if (certificate == nullptr) {
    return NotUsable("access.certificate", chain_path_, "has no certificate in PEM");
  }
  const PrivateKey key = KeyOf(read.key);
  if (key == nullptr) {
    return NotUsable("access.key", key_path_, "has no private key without a password in PEM");
  }
  if (X509_check_private_key(certificate.get(), key.get()) != 1) {
    return NotUsable("access.key", key_path_,
                     absl::StrCat("is not the key of the certificate in ", chain_path_));
  }
  if (authorities_path_.empty()) return read;
  CELT_ASSIGN_OR_RETURN(read.client_authorities, ReadFile("access.client_ca", authorities_path_));
  if (CertificateOf(read.client_authorities) != nullptr) return read;
  return NotUsable("access.client_ca", authorities_path_, "has no certificate in PEM");
}

}  // namespace celt::host
