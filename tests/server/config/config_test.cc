#include "server/config/config.h"

#include <fstream>
#include <string>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "temporary_directory.h"

namespace celt::config {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

class ConfigTest : public ::testing::Test {
 protected:
  absl::Status Read(const std::string& text) {
    std::ofstream(path_) << text;
    return ReadFile(path_, config_);
  }
  /// The message, without the path: "line: …".
  std::string Error(const std::string& text) {
    const std::string message(Read(text).message());
    EXPECT_TRUE(message.starts_with(path_ + ":")) << message;
    return message.substr(std::min(path_.size() + 1, message.size()));
  }
  std::string CheckError() const { return std::string(Check(config_).message()); }

  TemporaryDirectory temporary_;
  std::string path_ = temporary_ / "celtd.toml";
  Config config_;
};

TEST_F(ConfigTest, TakesWhatTheFileSaysAndLeavesTheRest) {
  const absl::Status status =
      Read("workers = 3\ndrain_seconds = 2\n[limits]\niterates = 5_000\n[log]\nformat = 'json'\n");
  ASSERT_TRUE(status.ok()) << status;
  EXPECT_EQ(config_.workers, 3);
  EXPECT_EQ(config_.drain_seconds, 2);
  EXPECT_EQ(config_.limits.iterates, 5000);
  EXPECT_EQ(config_.limits.nodes, Config().limits.nodes);
  EXPECT_EQ(config_.log.format, "json");
}

TEST_F(ConfigTest, NamesTheLineOfWhatIsWrong) {
  EXPECT_EQ(Error("workers = 1\nworkerz = 2\n"), "2: workerz: there is no such setting");
  EXPECT_EQ(Error("\n\n[limit]\nnodes = 2\n"), "3: limit: there is no such table");
  EXPECT_EQ(Error("[limits]\nnodes = 'many'\n"), "2: limits.nodes: a whole number is expected");
  EXPECT_EQ(Error("listen = 5\n"), "1: listen: a text is expected");
  EXPECT_EQ(Error("listen = [5]\n"), "1: listen: a text or a number is expected");
  EXPECT_EQ(Error("workers = 2000\n"), "1: workers: 2000 is not allowed; it lies in [0, 1024]");
  EXPECT_EQ(Error("\ndrain_seconds = nan\n"),
            "2: drain_seconds: nan is not allowed; it lies in [0, 100000]");
  EXPECT_EQ(Error("[log]\nlevel = 'loud'\n"),
            "2: log.level: loud is not allowed; it is one of trace, debug, info, warning, error, "
            "critical");
  EXPECT_EQ(Error("[store]\nsynchronous = 'off'\n"),
            "2: store.synchronous: off is not allowed; it is one of normal, full");
  EXPECT_THAT(Error("workers = 1\nlisten = \n"), ::testing::StartsWith("2: "));
}

TEST_F(ConfigTest, NamesAFileThatIsNotThere) {
  EXPECT_THAT(std::string(ReadFile(path_, config_).message()), ::testing::StartsWith(path_ + ": "));
}

TEST_F(ConfigTest, IsFineAsItIsByDefault) {
  config_.data_dir = "/data";
  EXPECT_EQ(CheckError(), "");
}

TEST_F(ConfigTest, LetsOthersThanLoopbackInOnlyWithTlsAndOwners) {
  config_.data_dir = "/data";
  config_.listen = "0.0.0.0:7350";
  EXPECT_THAT(CheckError(), HasSubstr("listen: 0.0.0.0:7350 is not a loopback address"));
  config_.access.tokens = "tokens";
  EXPECT_THAT(CheckError(), HasSubstr("not a loopback address")) << "tokens would be sent in clear";
  config_.access.certificate = "certificate";
  EXPECT_THAT(CheckError(), HasSubstr("access.key: "));
  config_.access.key = "key";
  EXPECT_EQ(CheckError(), "");
  config_.access.tokens.clear();
  EXPECT_THAT(CheckError(), HasSubstr("not a loopback address")) << "nobody is known";
  config_.access.client_ca = "authorities";
  EXPECT_EQ(CheckError(), "");
  for (const char* loopback : {"127.0.0.1:0", "localhost:7350", "[::1]:7350", "127.1.2.3:1"}) {
    config_.access = {};
    config_.listen = loopback;
    EXPECT_EQ(CheckError(), "");
  }
}

TEST_F(ConfigTest, ChecksAddresses) {
  config_.data_dir = "/data";
  for (const char* bad : {"", "7350", ":7350", "host:", "host:port", "host:123456"}) {
    config_.listen = bad;
    EXPECT_THAT(CheckError(), EndsWith("is not HOST:PORT")) << bad;
  }
}

TEST(Setting, HasAFlagOfItsOwn) {
  Config config;
  std::string flags;
  for (const Setting& setting : SettingsOf(config)) flags += setting.Flag() + " ";
  EXPECT_THAT(flags, HasSubstr("--listen "));
  EXPECT_THAT(flags, HasSubstr("--limits-unfinished-jobs-per-owner "));
}

}  // namespace
}  // namespace celt::config
