#include "server/host/certificates.h"

#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "server/host/host.h"
#include "temporary_directory.h"

namespace celt::host {
namespace {

using ::testing::HasSubstr;

class CertificateFilesTest : public ::testing::Test {
 protected:
  /// Writes NAME.pem, a certificate that signs itself, and NAME.key.
  void Make(const std::string& name) const {
    using File = std::unique_ptr<std::FILE, decltype(&std::fclose)>;
    const std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)> key(EVP_EC_gen("P-256"),
                                                                  EVP_PKEY_free);
    const std::unique_ptr<X509, decltype(&X509_free)> made(X509_new(), X509_free);
    X509_gmtime_adj(X509_getm_notBefore(made.get()), 0);
    X509_gmtime_adj(X509_getm_notAfter(made.get()), 86'400);
    X509_set_pubkey(made.get(), key.get());
    X509_sign(made.get(), key.get(), EVP_sha256());
    const File certificate(std::fopen(Path(name + ".pem").c_str(), "w"), std::fclose);
    PEM_write_X509(certificate.get(), made.get());
    const File secret(std::fopen(Path(name + ".key").c_str(), "w"), std::fclose);
    PEM_write_PrivateKey(secret.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr);
  }
  void Replace(const std::string& name, const std::string& by) const {
    std::filesystem::copy_file(Path(by), Path("copy"),
                               std::filesystem::copy_options::overwrite_existing);
    std::filesystem::rename(Path("copy"), Path(name));
  }
  std::string Path(const std::string& name) const { return temporary_ / name; }

  absl::StatusOr<std::unique_ptr<CertificateFiles>> Open() {
    auth::WatchOptions options;
    options.clock = [this] { return now_ += absl::Seconds(1); };
    options.on_error = [this](const absl::Status& error) { told_ = error; };
    return CertificateFiles::Open(keys_, options);
  }
  std::string Error() { return std::string(Open().status().message()); }

  void SetUp() override {
    for (const char* name : {"server", "other", "authority"}) Make(name);
    keys_.certificate = Path("server.pem");
    keys_.key = Path("server.key");
  }

  TemporaryDirectory temporary_;
  Keys keys_;
  absl::Time now_ = absl::UnixEpoch();
  absl::Status told_;
};

TEST_F(CertificateFilesTest, AreTakenOnceUntilTheyChange) {
  const auto files = Open();
  ASSERT_TRUE(files.ok()) << files.status();
  const auto first = (*files)->Take();
  ASSERT_TRUE(first.has_value());
  EXPECT_THAT(first->chain, HasSubstr("BEGIN CERTIFICATE"));
  EXPECT_FALSE((*files)->Take().has_value());
  Replace("server.pem", "other.pem");
  Replace("server.key", "other.key");
  const auto second = (*files)->Take();
  ASSERT_TRUE(second.has_value());
  EXPECT_NE(second->chain, first->chain);
  EXPECT_NE(second->key, first->key);
  EXPECT_TRUE(told_.ok()) << told_;
}

TEST_F(CertificateFilesTest, AuthoritiesOfClientsAreReadAgainToo) {
  keys_.client_ca = Path("authority.pem");
  const auto files = Open();
  ASSERT_TRUE(files.ok()) << files.status();
  const auto first = (*files)->Take();
  Replace("authority.pem", "other.pem");
  const auto second = (*files)->Take();
  ASSERT_TRUE(second.has_value());
  EXPECT_NE(second->client_authorities, first->client_authorities);
  EXPECT_EQ(second->chain, first->chain);
}

TEST_F(CertificateFilesTest, ThatCanNotBeUsedAreToldOfAndLeaveWhatWasBefore) {
  const auto files = Open();
  ASSERT_TRUE((*files)->Take().has_value());
  Replace("server.pem", "other.pem");
  EXPECT_FALSE((*files)->Take().has_value());
  EXPECT_EQ(told_.message(), "access.key: " + Path("server.key") +
                                 " is not the key of the certificate in " + Path("server.pem") +
                                 "; the certificate that was read before holds");
  Replace("server.key", "other.key");
  EXPECT_TRUE((*files)->Take().has_value()) << "now they fit";
}

TEST_F(CertificateFilesTest, AreRefusedAtTheStartByTheSettingThatIsWrong) {
  keys_.certificate = Path("nothing");
  EXPECT_EQ(Error(), "access.certificate: " + Path("nothing") + " can't be read");
  keys_.certificate = Path("server.key");
  EXPECT_THAT(Error(), HasSubstr("access.certificate: " + Path("server.key") + " has no certif"));
  keys_.certificate = Path("server.pem");
  keys_.key = Path("server.pem");
  EXPECT_THAT(Error(), HasSubstr("access.key: " + Path("server.pem") + " has no private key"));
  keys_.key = Path("other.key");
  EXPECT_THAT(Error(), HasSubstr("is not the key of the certificate"));
  keys_.key = Path("server.key");
  keys_.client_ca = Path("server.key");
  EXPECT_THAT(Error(), HasSubstr("access.client_ca: "));
}

}  // namespace
}  // namespace celt::host
