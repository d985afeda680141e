#include "server/log/log.h"

#include "gtest/gtest.h"

namespace celt::log {
namespace {

TEST(Log, IsReadByPeopleAndByPrograms) {
  const Fields fields = {{"job", "abc"}, {"owner", ""}, {"error", "a \"b\"\n"}};
  EXPECT_EQ(AsText("job ended", fields), "job ended job=abc error=\"a \\\"b\\\"\\u000a\"");
  EXPECT_EQ(AsJson("job ended", fields),
            "\"event\":\"job ended\",\"job\":\"abc\",\"error\":\"a \\\"b\\\"\\u000a\"");
}

TEST(Log, LetsNobodyWriteALineOfTheirOwn) {
  EXPECT_EQ(AsText("call", {{"request", "x\nfake line"}}).find('\n'), std::string::npos);
  EXPECT_EQ(AsJson("call", {{"request", "x\nfake line"}}).find('\n'), std::string::npos);
}

TEST(Log, CutsWhatIsLong) {
  for (const char letter : {'x', '\n'}) {
    const Fields fields = {{"error", std::string(1'000'000, letter)}};
    EXPECT_LT(AsText("call", fields).size(), 1100);
    EXPECT_LT(AsJson("call", fields).size(), 1100);
    EXPECT_TRUE(AsText("call", fields).ends_with("...\""));
  }
}

}  // namespace
}  // namespace celt::log
