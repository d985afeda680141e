#include "server/jobs/page_token.h"

#include <limits>

#include "gtest/gtest.h"

namespace celt::jobs {
namespace {

TEST(PageToken, ComesBackAsItWas) {
  for (const std::int64_t serial : {std::int64_t{0}, std::numeric_limits<std::int64_t>::max()}) {
    const auto token = DecodePageToken(Encode({serial, 0x2a}));
    ASSERT_TRUE(token.ok()) << token.status();
    EXPECT_EQ(token->before_serial, serial);
    EXPECT_EQ(token->states, 0x2aU);
  }
}

TEST(PageToken, ThatIsNotOursIsRefused) {
  for (const char* text : {"x", ".", "1", "1.", ".1", "-1.0", "1.-1", "1.2.3", "1 .2", "g.0",
                           "0x1.0", "8000000000000000.0", "1.100000000", "\n1.0"}) {
    EXPECT_EQ(DecodePageToken(text).status().code(), absl::StatusCode::kInvalidArgument) << text;
  }
}

}  // namespace
}  // namespace celt::jobs
