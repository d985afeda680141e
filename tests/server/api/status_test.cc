#include "server/api/status.h"

#include <string>

#include "gtest/gtest.h"

namespace celt::api {
namespace {

TEST(ToGrpc, KeepsCodeAndMessage) {
  const grpc::Status status = ToGrpc(absl::OutOfRangeError("lost"));
  EXPECT_EQ(status.error_code(), grpc::StatusCode::OUT_OF_RANGE);
  EXPECT_EQ(status.error_message(), "lost");
  EXPECT_TRUE(ToGrpc(absl::OkStatus()).ok());
}

TEST(ToGrpc, ShortensWhatWouldNotFitIntoAHeader) {
  EXPECT_LT(ToGrpc(absl::NotFoundError(std::string(1'000'000, 'x'))).error_message().size(), 1100U);
}

TEST(ToGrpc, CutsBetweenCharacters) {
  std::string text = "a";
  for (int i = 0; i < 1000; ++i)
    text += "\u00e9";  // two bytes each, so that every even place is inside of one
  std::string cut = ToGrpc(absl::NotFoundError(text)).error_message();
  ASSERT_TRUE(cut.ends_with("..."));
  cut.resize(cut.size() - 3);
  EXPECT_EQ(cut.size() % 2, 1U);
  EXPECT_TRUE(text.starts_with(cut));
}

}  // namespace
}  // namespace celt::api
