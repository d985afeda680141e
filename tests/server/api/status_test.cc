#include "server/api/status.h"

#include <string>

#include "absl/strings/cord.h"
#include "gtest/gtest.h"
#include "server/api/error_details.pb.h"
#include "server/jobs/status_details.h"

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

google::rpc::Status DetailsOf(const absl::Status& status) {
  google::rpc::Status details;
  EXPECT_TRUE(details.ParseFromString(ToGrpc(status).error_details()));
  return details;
}

TEST(ToGrpc, NamesTheFieldThatIsWrong) {
  const auto details = DetailsOf(absl::InvalidArgumentError("axes[1].from: missing"));
  EXPECT_EQ(details.code(), 3);
  google::rpc::BadRequest request;
  ASSERT_EQ(details.details_size(), 1);
  ASSERT_TRUE(details.details(0).UnpackTo(&request));
  EXPECT_EQ(request.field_violations(0).field(), "axes[1].from");
}

TEST(ToGrpc, SaysWhenToTryAgain) {
  absl::Status status = absl::ResourceExhaustedError("the queue is full");
  status.SetPayload(jobs::kRetrySecondsPayload, absl::Cord("7"));
  google::rpc::RetryInfo retry;
  ASSERT_TRUE(DetailsOf(status).details(0).UnpackTo(&retry));
  EXPECT_EQ(retry.retry_delay().seconds(), 7);
}

TEST(ToGrpc, HasNoDetailsWhereThereAreNone) {
  EXPECT_EQ(ToGrpc(absl::NotFoundError("id: nobody")).error_details(), "");
  EXPECT_EQ(ToGrpc(absl::InvalidArgumentError("nothing of a field")).error_details(), "");
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
