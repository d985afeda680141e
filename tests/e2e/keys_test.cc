// Who may speak to a server, and over what.

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/e2e/daemon.h"

namespace celt {
namespace {

using ::testing::HasSubstr;

using Arguments = std::vector<std::string>;

class KeysTest : public ::testing::Test {
 protected:
  std::string Path(const std::string& name) const { return keys_.path() + "/" + name; }

  static void OpenSsl(const Arguments& arguments) {
    const Ended run = Process("/usr/bin/openssl", arguments).Wait();
    ASSERT_EQ(run.code, 0) << run.err;
  }
  /// An authority that signs itself, valid for an hour's test and a day.
  void MakeAuthority() const {
    OpenSsl({"req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes",
             "-days", "1", "-subj", "/CN=authority", "-keyout", Path("ca.key"), "-out",
             Path("ca.pem")});
  }
  void MakeCertificate(const std::string& name) const {
    std::ofstream(Path("names")) << "subjectAltName=IP:127.0.0.1\n";
    OpenSsl({"req", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-subj",
             "/CN=" + name, "-keyout", Path(name + ".key"), "-out", Path(name + ".csr")});
    OpenSsl({"x509", "-req", "-in", Path(name + ".csr"), "-CA", Path("ca.pem"), "-CAkey",
             Path("ca.key"), "-CAcreateserial", "-days", "1", "-extfile", Path("names"), "-out",
             Path(name + ".pem")});
  }
  /// Lets an owner in; the file with their token.
  std::string AddToken(const std::string& owner) const {
    const std::string made = Process(CELTD_PROGRAM, {"--new-token", owner}).Wait().out;
    std::istringstream lines(made);
    std::string token;
    std::string line;
    std::getline(lines, token);
    std::getline(lines, line);
    std::ofstream(Path("tokens"), std::ios::app) << line.substr(line.find(':') + 1) << "\n";
    std::ofstream(Path(owner)) << token.substr(token.find(':') + 1) << "\n";
    return Path(owner);
  }

  TemporaryDirectory data_;
  TemporaryDirectory keys_;
  Celt celt_;
};

const Arguments kQuestion = {"lyapunov", "--system", "henon3d", "--iterates", "1000", "--detach"};

TEST_F(KeysTest, TokensKeepOwnersApart) {
  const Arguments anna = {"--token-file", AddToken("anna")};
  const Arguments boris = {"--token-file", AddToken("boris")};
  const Daemon daemon(data_.path(), 1, "127.0.0.1:0", {"--access-tokens", Path("tokens")});
  const Arguments server = {"--server", daemon.address()};
  EXPECT_EQ(celt_.Run(With(With(kQuestion, server), anna)).code, 0);
  EXPECT_THAT(celt_.Run(With(With({"jobs", "list"}, server), anna)).out, HasSubstr("anna"));
  EXPECT_EQ(celt_.Run(With(With({"jobs", "list"}, server), boris)).out, "");
  const Ended nobody = celt_.Run(With(kQuestion, server));
  EXPECT_EQ(nobody.code, 3);
  EXPECT_THAT(nobody.err, HasSubstr("this server wants a token"));
}

TEST_F(KeysTest, TlsEncryptsAndNamesTheServer) {
  MakeAuthority();
  MakeCertificate("server");
  const Daemon daemon(data_.path(), 1, "127.0.0.1:0",
                      {"--access-certificate", Path("server.pem"), "--access-key",
                       Path("server.key"), "--access-tokens", (AddToken("anna"), Path("tokens"))});
  const Arguments asked = {"server",       "info",       "--server", daemon.address(),
                           "--token-file", Path("anna"), "--tls-ca", Path("ca.pem")};
  const Ended known = celt_.Run(asked);
  EXPECT_EQ(known.code, 0) << known.err;
  Arguments in_clear = asked;
  in_clear.resize(asked.size() - 2);
  EXPECT_EQ(celt_.Run(in_clear).code, 3);
  Arguments untrusting = With(in_clear, {"--tls"});
  EXPECT_EQ(celt_.Run(untrusting).code, 3) << "the system knows no such authority";
}

TEST_F(KeysTest, CertificatesOfClientsNameTheirOwners) {
  MakeAuthority();
  for (const char* name : {"server", "anna", "boris"}) MakeCertificate(name);
  const Daemon daemon(data_.path(), 1, "127.0.0.1:0",
                      {"--access-certificate", Path("server.pem"), "--access-key",
                       Path("server.key"), "--access-client-ca", Path("ca.pem")});
  const auto as = [&](const std::string& name, const Arguments& arguments) {
    return celt_.Run(With(
        arguments, {"--server", daemon.address(), "--tls-ca", Path("ca.pem"), "--tls-certificate",
                    Path(name + ".pem"), "--tls-key", Path(name + ".key")}));
  };
  const Ended submitted = as("anna", kQuestion);
  EXPECT_EQ(submitted.code, 0) << submitted.err;
  EXPECT_THAT(as("anna", {"jobs", "list"}).out, HasSubstr("\"owner\":\"anna\""));
  EXPECT_EQ(as("boris", {"jobs", "list"}).out, "");
  EXPECT_EQ(
      celt_.Run({"server", "info", "--server", daemon.address(), "--tls-ca", Path("ca.pem")}).code,
      3)
      << "without a certificate";
}

TEST_F(KeysTest, ANewCertificateIsShownWithoutARestart) {
  MakeAuthority();
  MakeCertificate("server");
  Daemon daemon(data_.path(), 1, "127.0.0.1:0",
                {"--access-certificate", Path("server.pem"), "--access-key", Path("server.key"),
                 "--access-client-ca", Path("ca.pem")});
  MakeCertificate("anna");
  const auto asked = [&](const std::string& authority) {
    return celt_
        .Run({"server", "info", "--server", daemon.address(), "--tls-ca", Path(authority),
              "--tls-certificate", Path("anna.pem"), "--tls-key", Path("anna.key")})
        .code;
  };
  std::filesystem::copy_file(Path("ca.pem"), Path("old.pem"));
  EXPECT_EQ(asked("old.pem"), 0);

  // A key of another certificate: who comes now still finds the old one.
  std::filesystem::copy_file(Path("anna.key"), Path("server.key"),
                             std::filesystem::copy_options::overwrite_existing);
  constexpr int kLooks = 4;  // at most one a second, and a run takes a while: some of them look
  for (int i = 0; i < kLooks; ++i) EXPECT_EQ(asked("old.pem"), 0);

  // All anew, the authority of clients too: who trusts the new one comes in, soon.
  MakeAuthority();
  MakeCertificate("server");
  MakeCertificate("anna");
  constexpr int kPatience = 200;
  int looks = 0;
  while (asked("ca.pem") != 0 && looks < kPatience) ++looks;
  EXPECT_LT(looks, kPatience);
  EXPECT_EQ(asked("old.pem"), 3) << "the old one is not shown any more";
  daemon.process().Signal(SIGTERM);
  EXPECT_EQ(daemon.process().Wait().code, 0);
}

TEST_F(KeysTest, WithoutKeysAServerStaysOnLoopback) {
  const Ended run =
      Process(CELTD_PROGRAM, {"--listen", "0.0.0.0:0", "--data-dir", data_.path()}).Wait();
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("listen: 0.0.0.0:0 is not a loopback address"));
}

}  // namespace
}  // namespace celt
