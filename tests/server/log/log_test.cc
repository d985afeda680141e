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

}  // namespace
}  // namespace celt::log
