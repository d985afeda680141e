#include "server/daemon/new_token.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "server/auth/tokens.h"

namespace celt::daemon {
namespace {

TEST(NewTokenText, HasATokenAndItsLine) {
  const auto text = NewTokenText("anna:admin");
  ASSERT_TRUE(text.ok()) << text.status();
  const std::string token = text->substr(text->find(": ") + 2, 64);
  EXPECT_EQ(*text, "token, for its owner alone: " + token + "\nline of the file of tokens:  " +
                       auth::TokenLine({"anna", true}, token) + "\n");
  EXPECT_THAT(*NewTokenText("anna"), ::testing::HasSubstr("anna user "));
}

TEST(NewTokenText, RefusesWhatWouldNotBeReadBackAsAnOwner) {
  for (const char* owner : {":admin", "anna:root", "#anna", "anna b", "anna\tb", "anna:"}) {
    EXPECT_TRUE(absl::IsInvalidArgument(NewTokenText(owner).status())) << owner;
  }
}

}  // namespace
}  // namespace celt::daemon
