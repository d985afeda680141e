#include "server/auth/gate.h"

#include <fstream>
#include <string>
#include <utility>

#include "gtest/gtest.h"
#include "temporary_directory.h"

namespace celt::auth {
namespace {

class GateTest : public ::testing::Test {
 protected:
  GateTest() {
    std::ofstream(temporary_ / "tokens") << TokenLine({"anna", true}, "secret") << "\n";
  }
  std::unique_ptr<TokenFile> Tokens() { return *TokenFile::Open(temporary_ / "tokens", {}); }
  static absl::StatusCode Code(const Gate& gate, const Credentials& credentials) {
    return gate.Identify(credentials).status().code();
  }

  TemporaryDirectory temporary_;
};

TEST_F(GateTest, WithoutKeysLetsEverybodyInAsTheOwnerOfAll) {
  const auto identity = Gate().Identify({});
  ASSERT_TRUE(identity.ok());
  EXPECT_EQ(identity->owner, "");
  EXPECT_TRUE(identity->admin);
}

TEST_F(GateTest, WithTokensLetsInWhoShowsOne) {
  const Gate gate(Tokens(), false);
  const auto identity = gate.Identify({.authorization = "Bearer secret", .common_name = ""});
  ASSERT_TRUE(identity.ok()) << identity.status();
  EXPECT_EQ(identity->owner, "anna");
  EXPECT_TRUE(identity->admin);
  for (const char* wrong : {"", "Bearer ", "Bearer secre", "Bearer secret ", "secret", "Basic x"}) {
    EXPECT_EQ(Code(gate, {.authorization = wrong, .common_name = "anna"}),
              absl::StatusCode::kUnauthenticated)
        << wrong;
  }
}

TEST_F(GateTest, WithCertificatesLetsInWhoHasOneWithAName) {
  const Gate gate(nullptr, true);
  const auto identity = gate.Identify({.authorization = "", .common_name = "boris"});
  ASSERT_TRUE(identity.ok()) << identity.status();
  EXPECT_EQ(identity->owner, "boris");
  EXPECT_FALSE(identity->admin);
  EXPECT_EQ(Code(gate, {}), absl::StatusCode::kUnauthenticated);
}

TEST_F(GateTest, WithBothATokenCountsBeforeACertificate) {
  const Gate gate(Tokens(), true);
  EXPECT_EQ(gate.Identify({.authorization = "Bearer secret", .common_name = "boris"})->owner,
            "anna");
  EXPECT_EQ(gate.Identify({.authorization = "", .common_name = "boris"})->owner, "boris");
  EXPECT_EQ(Code(gate, {.authorization = "Bearer wrong", .common_name = "boris"}),
            absl::StatusCode::kUnauthenticated);
}

}  // namespace
}  // namespace celt::auth
