#include "server/auth/tokens.h"

#include <fstream>
#include <string>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "temporary_directory.h"

namespace celt::auth {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

class TokenFileTest : public ::testing::Test {
 protected:
  void Write(const std::string& text) { std::ofstream(path_) << text; }
  absl::StatusOr<std::unique_ptr<TokenFile>> Open() {
    WatchOptions options;
    options.clock = [this] { return now_; };
    options.on_error = [this](const absl::Status& error) { told_ = error; };
    return TokenFile::Open(path_, options);
  }
  std::string Error(const std::string& text) {
    Write(text);
    return std::string(Open().status().message());
  }

  TemporaryDirectory temporary_;
  std::string path_ = temporary_ / "tokens";
  absl::Time now_ = absl::UnixEpoch();
  absl::Status told_;
};

TEST(HashOf, IsSha256) {
  // FIPS 180-2, appendix B.1.
  EXPECT_EQ(HashOf("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(HashOf(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(NewToken, IsLongAndNeverTheSame) {
  EXPECT_EQ(NewToken().size(), 64U);
  EXPECT_NE(NewToken(), NewToken());
}

TEST_F(TokenFileTest, TellsOwnersAndRolesByTheirTokens) {
  Write("# who may come in\n\n" + TokenLine({"anna", false}, "a") + "\n  " +
        TokenLine({"boris", true}, "b") + "\n");
  const auto tokens = Open();
  ASSERT_TRUE(tokens.ok()) << tokens.status();
  EXPECT_EQ((*tokens)->Find("a")->owner, "anna");
  EXPECT_FALSE((*tokens)->Find("a")->admin);
  EXPECT_EQ((*tokens)->Find("b")->owner, "boris");
  EXPECT_TRUE((*tokens)->Find("b")->admin);
  EXPECT_FALSE((*tokens)->Find("c").has_value());
  EXPECT_FALSE((*tokens)->Find("").has_value());
  EXPECT_FALSE((*tokens)->Find(HashOf("a")).has_value()) << "what is at rest opens nothing";
}

TEST_F(TokenFileTest, KeepsNoTokenAtRest) {
  EXPECT_THAT(TokenLine({"anna", false}, "secret"), Not(HasSubstr("secret")));
}

TEST_F(TokenFileTest, NamesTheLineOfWhatIsWrong) {
  const std::string good = TokenLine({"anna", false}, "a");
  EXPECT_EQ(Error(good + "\nboris root " + HashOf("b")),
            path_ + ":2: the role is neither user nor admin");
  EXPECT_EQ(Error("anna user abc"), path_ + ":1: the hash is not 64 hexadecimal digits");
  EXPECT_EQ(Error("anna"), path_ + ":1: the role is neither user nor admin");
  EXPECT_EQ(Error(good + " x"), path_ + ":1: there is more than OWNER ROLE HASH");
}

TEST_F(TokenFileTest, SaysThatThereIsNone) {
  EXPECT_THAT(std::string(Open().status().message()), EndsWith("tokens: can't be read"));
}

TEST_F(TokenFileTest, IsReadAgainWhenItHasChanged) {
  Write(TokenLine({"anna", false}, "a"));
  const auto tokens = Open();
  ASSERT_TRUE(tokens.ok()) << tokens.status();
  Write(TokenLine({"boris", false}, "b") + "\n");
  EXPECT_TRUE((*tokens)->Find("a").has_value()) << "not looked at more often than needed";
  now_ += absl::Seconds(2);
  EXPECT_FALSE((*tokens)->Find("a").has_value());
  EXPECT_EQ((*tokens)->Find("b")->owner, "boris");
}

TEST_F(TokenFileTest, HoldsToWhatItSaidWhileItIsWrong) {
  Write(TokenLine({"anna", false}, "a"));
  const auto tokens = Open();
  Write("nonsense");
  now_ += absl::Seconds(2);
  EXPECT_TRUE((*tokens)->Find("a").has_value());
  EXPECT_THAT(std::string(told_.message()), HasSubstr("tokens:1: "));
}

}  // namespace
}  // namespace celt::auth
