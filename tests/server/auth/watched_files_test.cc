#include "server/auth/watched_files.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "gtest/gtest.h"
#include "temporary_directory.h"

namespace celt::auth {
namespace {

class WatchedFilesTest : public ::testing::Test {
 protected:
  void Write(const std::string& name, const std::string& text) {
    std::ofstream(temporary_ / name) << text;
  }
  /// A second later.
  bool Changed() {
    now_ += absl::Seconds(1);
    return files_->Changed();
  }
  void Watch() {
    WatchOptions options;
    options.clock = [this] { return now_; };
    files_.emplace(std::vector<std::string>{temporary_ / "a", "", temporary_ / "b"}, options);
  }

  TemporaryDirectory temporary_;
  absl::Time now_ = absl::UnixEpoch();
  std::optional<WatchedFiles> files_;
};

TEST_F(WatchedFilesTest, TellOfEachChangeOnce) {
  Write("a", "1");
  Write("b", "1");
  Watch();
  EXPECT_FALSE(Changed());
  Write("b", "22");
  EXPECT_TRUE(Changed());
  EXPECT_FALSE(Changed());
}

TEST_F(WatchedFilesTest, TellOfAFileThatIsReplacedGoesAndComes) {
  Write("a", "1");
  Write("new", "2");
  Watch();
  std::filesystem::rename(temporary_ / "new", temporary_ / "a");
  EXPECT_TRUE(Changed()) << "of the same length, and perhaps of the same moment";
  std::filesystem::remove(temporary_ / "a");
  EXPECT_TRUE(Changed());
  Write("a", "1");
  EXPECT_TRUE(Changed());
}

TEST_F(WatchedFilesTest, AreNotLookedAtTooOften) {
  Write("a", "1");
  Watch();
  Write("a", "22");
  EXPECT_FALSE(files_->Changed());
  EXPECT_TRUE(Changed());
}

}  // namespace
}  // namespace celt::auth
