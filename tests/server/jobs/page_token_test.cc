#include "server/jobs/page_token.h"

#include <limits>

#include "gtest/gtest.h"

namespace celt::jobs {
namespace {

TEST(PageToken, ComesBackAsItWas) {
  for (const std::int64_t created : {std::int64_t{0}, std::numeric_limits<std::int64_t>::max()}) {
    const auto token = DecodePageToken(Encode({created, 0x2a, "a.b"}));
    ASSERT_TRUE(token.ok()) << token.status();
    EXPECT_EQ(token->created, created);
    EXPECT_EQ(token->states, 0x2aU);
    EXPECT_EQ(token->id, "a.b");
  }
}

TEST(PageToken, ThatIsNotOursIsRefused) {
  for (const char* text :
       {"x", ".", "..", "1", "1.", "1.1", "1.1.", ".1.a", "1..a", "-1.0.a", "1.-1.a", "1 .2.a",
        "g.0.a", "0x1.0.a", "8000000000000000.0.a", "1.100000000.a", "\n1.0.a"}) {
    EXPECT_EQ(DecodePageToken(text).status().code(), absl::StatusCode::kInvalidArgument) << text;
  }
}

}  // namespace
}  // namespace celt::jobs
