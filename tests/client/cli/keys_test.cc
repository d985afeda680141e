#include "client/cli/keys.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/client/fake_service.h"
#include "tests/client/run_celt.h"

namespace celt {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class KeysTest : public ::testing::Test {
 protected:
  KeysTest() { std::ofstream(path_) << "from-the-file\n"; }
  ~KeysTest() override { std::filesystem::remove(path_); }

  std::string Shown(const std::vector<std::string>& options, const std::string& token) {
    std::vector<std::string> arguments = {"lyapunov", "--detach"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = RunCelt(arguments, {.server = service_.address(), .token = token});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return service_.authorization();
  }

  FakeService service_;
  std::string path_ = ::testing::TempDir() + "celt-token-" +
                      ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(KeysTest, TokenIsShownFromTheFileOrTheEnvironment) {
  EXPECT_EQ(Shown({}, ""), "");
  EXPECT_EQ(Shown({}, "from-the-environment"), "Bearer from-the-environment");
  EXPECT_EQ(Shown({"--token-file", path_}, "from-the-environment"), "Bearer from-the-file");
}

TEST_F(KeysTest, TokenDoesNotTravelInClear) {
  const Outcome outcome =
      RunCelt({"server", "info"}, {.server = "celt.example.org:7350", .token = "secret"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, StartsWith("celt: --server: a token does not travel in clear"));
  EXPECT_THAT(outcome.err, ::testing::Not(HasSubstr("secret")));
}

TEST_F(KeysTest, FileThatCanNotBeReadIsNamedWithItsOption) {
  for (const char* option : {"--token-file", "--tls-ca"}) {
    const Outcome outcome =
        RunCelt({"server", "info", option, "/nowhere"}, {.server = service_.address()});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err, std::string("celt: ") + option + ": '/nowhere' can't be read\n");
  }
}

TEST_F(KeysTest, CertificateGoesWithItsKey) {
  const Outcome outcome =
      RunCelt({"server", "info", "--tls-certificate", path_}, {.server = service_.address()});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, StartsWith("celt: --tls-key: "));
}

}  // namespace
}  // namespace celt
