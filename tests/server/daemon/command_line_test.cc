#include "server/daemon/command_line.h"

#include <fstream>
#include <string>
#include <vector>

#include "gtest/gtest.h"
#include "temporary_directory.h"

namespace celt::daemon {
namespace {

CommandLine Read(const std::vector<const char*>& arguments) {
  std::vector<const char*> line = {"celtd"};
  line.insert(line.end(), arguments.begin(), arguments.end());
  return ReadCommandLine(static_cast<int>(line.size()), line.data());
}

TEST(CommandLine, HasAFlagForEverySettingOfEveryKind) {
  const CommandLine line = Read({"--data-dir", "/data", "--limits-nodes", "7", "--drain-seconds",
                                 "0.5", "--log-level", "debug"});
  EXPECT_FALSE(line.exit.has_value());
  EXPECT_EQ(line.config.data_dir, "/data");
  EXPECT_EQ(line.config.limits.nodes, 7);
  EXPECT_EQ(line.config.drain_seconds, 0.5);
  EXPECT_EQ(line.config.log.level, "debug");
  EXPECT_FALSE(line.check);
}

TEST(CommandLine, WinsOverTheFileWhereverItStands) {
  const TemporaryDirectory temporary;
  const std::string path = temporary / "celtd.toml";
  std::ofstream(path) << "data_dir = '/data'\nworkers = 3\n[limits]\nnodes = 5\n";
  const CommandLine line = Read({"--limits-nodes", "7", "--config", path.c_str(), "--check"});
  EXPECT_EQ(line.config.workers, 3);
  EXPECT_EQ(line.config.limits.nodes, 7);
  EXPECT_TRUE(line.check);
}

TEST(CommandLine, EndsWithTheCodeThatFits) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(Read({"--help"}).exit, 0);
  EXPECT_EQ(Read({"--version"}).exit, 0);
  EXPECT_EQ(Read({"--no-such-flag"}).exit, kConfigurationWrong);
  EXPECT_EQ(Read({"--workers", "-1"}).exit, kConfigurationWrong);
  EXPECT_EQ(Read({"--listen", "nowhere"}).exit, kConfigurationWrong);
  testing::internal::GetCapturedStdout();
  EXPECT_NE(testing::internal::GetCapturedStderr().find("listen: 'nowhere' is not HOST:PORT"),
            std::string::npos);
}

}  // namespace
}  // namespace celt::daemon
