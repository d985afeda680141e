#include "client/cli/parse.h"

#include <cstdint>
#include <limits>

#include "gtest/gtest.h"

namespace celt::cli {
namespace {

constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

TEST(ParseNumber, TakesDecimals) {
  EXPECT_EQ(ParseNumber("752").value(), 752);
  EXPECT_EQ(ParseNumber("-0.5").value(), -0.5);
  EXPECT_EQ(ParseNumber("1e-11").value(), 1e-11);
}

TEST(ParseNumber, RefusesAllThatIsNotAFiniteNumberToItsEnd) {
  for (const char* text : {"", " ", "nan", "-nan", "inf", "-infinity", "1e3x", "1,5", " 1", "1 ",
                           "0x10", "1e999", "--1", "+-1", "seven"}) {
    EXPECT_EQ(ParseNumber(text).status().code(), absl::StatusCode::kInvalidArgument) << text;
  }
}

TEST(ParseNumber, ErrorShowsTheValueAndWhatIsAllowed) {
  EXPECT_EQ(ParseNumber("1e3x").status().message(), "'1e3x' is no finite number");
}

TEST(ParseInteger, TakesDigitsAndExactFloatingPoint) {
  EXPECT_EQ(ParseInteger("20000", 0, kMost).value(), 20000);
  EXPECT_EQ(ParseInteger("1e6", 0, kMost).value(), 1000000);
  EXPECT_EQ(ParseInteger("1.5e3", 0, kMost).value(), 1500);
  EXPECT_EQ(ParseInteger("9223372036854775807", 0, kMost).value(), kMost);
  EXPECT_EQ(ParseInteger("-3", -5, 5).value(), -3);
}

TEST(ParseInteger, RefusesFractionsAndWhatIsOutOfRange) {
  for (const char* text : {"1.5", "1e-1", "nan", "inf", "1e17", "1e300", "9223372036854775808", "",
                           "2x", "11", "-1"}) {
    EXPECT_FALSE(ParseInteger(text, 0, 10).ok()) << text;
  }
}

TEST(ParseUnsigned, SpansAllSeeds) {
  EXPECT_EQ(ParseUnsigned("18446744073709551615").value(),
            std::numeric_limits<std::uint64_t>::max());
  EXPECT_FALSE(ParseUnsigned("18446744073709551616").ok());
  EXPECT_FALSE(ParseUnsigned("-1").ok());
}

TEST(ParseNumbers, WantsAsManyAsThereAreNames) {
  EXPECT_EQ(ParseNumbers("2,6,7", {"I1", "I2", "I3"}).value(), (std::vector<double>{2, 6, 7}));
  EXPECT_EQ(ParseNumbers("2,6", {"I1", "I2", "I3"}).status().message(),
            "'2,6' should be 3 numbers: I1,I2,I3");
  EXPECT_EQ(ParseNumbers("2,,7", {"I1", "I2", "I3"}).status().message(),
            "'2,,7' holds '' is no finite number");
}

TEST(ParseNumbers, WithoutNamesTakesAnyNumberOfThem) {
  EXPECT_EQ(ParseNumbers("1,-2", {}).value(), (std::vector<double>{1, -2}));
  EXPECT_FALSE(ParseNumbers("", {}).ok());
}

TEST(ParseAssignment, SplitsNameAndNumber) {
  EXPECT_EQ(ParseAssignment("rho=28").value(), (std::pair<std::string, double>("rho", 28)));
  for (const char* text : {"rho", "=28", "rho=", "rho=x", "rho=28=3", "rho= 28"}) {
    EXPECT_FALSE(ParseAssignment(text).ok()) << text;
  }
}

TEST(ParseAddress, WantsHostAndPort) {
  for (const char* text : {"127.0.0.1:7350", "localhost:1", "[::1]:65535", "celt.example.org:80"}) {
    EXPECT_TRUE(ParseAddress(text).ok()) << text;
  }
  for (const char* text : {"", "localhost", "localhost:", ":7350", "localhost:0", "localhost:65536",
                           "::1:7350", "dns:///a:1", "a b:1", "localhost:7350x"}) {
    EXPECT_FALSE(ParseAddress(text).ok()) << text;
  }
}

}  // namespace
}  // namespace celt::cli
