#include "server/jobs/data_dir.h"

#include <filesystem>
#include <fstream>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "temporary_directory.h"

namespace celt::jobs {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

TEST(DataDir, IsMadeForItsOwnerOnly) {
  const TemporaryDirectory temporary;
  const auto directory = DataDir::Lock(temporary / "state/celt");
  ASSERT_TRUE(directory.ok()) << directory.status();
  EXPECT_EQ(fs::status(temporary / "state/celt").permissions(), fs::perms::owner_all);
}

TEST(DataDir, IsHeldByOneAtATime) {
  const TemporaryDirectory temporary;
  {
    const auto first = DataDir::Lock(temporary.path());
    ASSERT_TRUE(first.ok()) << first.status();
    const auto second = DataDir::Lock(temporary.path());
    EXPECT_EQ(second.status().code(), absl::StatusCode::kUnavailable);
    EXPECT_THAT(std::string(second.status().message()), HasSubstr("in use by another celt"));
  }
  EXPECT_TRUE(DataDir::Lock(temporary.path()).ok());
}

TEST(DataDir, KeepsItsLockWhenMoved) {
  const TemporaryDirectory temporary;
  auto first = DataDir::Lock(temporary.path());
  ASSERT_TRUE(first.ok()) << first.status();
  const DataDir moved = *std::move(first);
  EXPECT_FALSE(DataDir::Lock(temporary.path()).ok());
}

TEST(DataDir, ThatIsAFileIsRefusedByName) {
  const TemporaryDirectory temporary;
  std::ofstream(temporary / "file") << "x";
  const auto directory = DataDir::Lock(temporary / "file");
  EXPECT_EQ(directory.status().code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_THAT(std::string(directory.status().message()), HasSubstr(temporary / "file"));
}

}  // namespace
}  // namespace celt::jobs
