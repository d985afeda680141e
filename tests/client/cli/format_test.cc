#include "client/cli/format.h"

#include "client/cli/csv.h"
#include "client/cli/text_table.h"
#include "gtest/gtest.h"

namespace celt::cli {
namespace {

TEST(WithError, ShowsTwoDigitsOfTheErrorAndTheValueToMatch) {
  EXPECT_EQ(WithError(0.0198213, 0.000214), "0.01982 ± 0.00021");
  EXPECT_EQ(WithError(-0.1723021, 0.0000114), "-0.172302 ± 0.000011");
  EXPECT_EQ(WithError(1234.5, 120), "1234 ± 120");
  EXPECT_EQ(WithError(12.34, 1.5), "12.3 ± 1.5");
}

TEST(WithError, RoundsTheErrorBeforeCountingItsDigits) {
  EXPECT_EQ(WithError(0.5, 0.000996), "0.5000 ± 0.0010");
}

TEST(WithError, ErrorThatSaysNothingIsNotShown) {
  EXPECT_EQ(WithError(0.784201, std::nullopt), "0.784201");
  EXPECT_EQ(WithError(1, 0), "1");
}

TEST(WithError, ErrorAtTheLevelOfRoundingDoesNotMakeUpDigits) {
  EXPECT_EQ(WithError(-0.35667494393873245, 3.1e-17), "-0.356674943939 ± 3.1e-17");
}

TEST(Shortest, ReadsBackAsTheSameNumber) {
  EXPECT_EQ(Shortest(0.1), "0.1");
  EXPECT_EQ(Shortest(752), "752");
  EXPECT_EQ(std::stod(Shortest(1.0 / 3)), 1.0 / 3);
}

TEST(Grouped, SetsThousandsApart) {
  EXPECT_EQ(Grouped(0), "0");
  EXPECT_EQ(Grouped(999), "999");
  EXPECT_EQ(Grouped(20000), "20 000");
  EXPECT_EQ(Grouped(-1234567), "-1 234 567");
}

TEST(Clock, ShowsHoursOnlyWhereThereAreAny) {
  EXPECT_EQ(Clock(absl::Seconds(7)), "0:07");
  EXPECT_EQ(Clock(absl::Seconds(3599)), "59:59");
  EXPECT_EQ(Clock(absl::Seconds(3 * 3600 + 4 * 60 + 5)), "3:04:05");
}

TEST(Width, CountsCharactersNotBytes) { EXPECT_EQ(Width("Λ1 ±"), 4); }

TEST(SystemTitle, NamesTheStoneByItsEnergyAndOthersByTheirParameters) {
  v1::System stone;
  (*stone.mutable_parameters())["energy"] = 752;
  (*stone.mutable_parameters())["mass"] = 1;
  EXPECT_EQ(SystemTitle(stone), "celtic-stone at energy 752");
  v1::System henon;
  henon.set_name("henon3d");
  (*henon.mutable_parameters())["m2"] = 0.85;
  (*henon.mutable_parameters())["b"] = 0.7;
  EXPECT_EQ(SystemTitle(henon), "henon3d: b = 0.7, m2 = 0.85");
}

TEST(TextTable, AlignsDigitsUnderEachOtherAndKeepsNoBlanksAtTheEnd) {
  TextTable table({"", "value"});
  table.Add({"Λ1", "0.5"});
  table.Add({"sum", "-0.25"});
  EXPECT_EQ(table.Text(),
            "       value\n"
            "  Λ1   0.5\n"
            "  sum -0.25\n");
}

TEST(CsvLine, QuotesOnlyWhatMustBe) {
  EXPECT_EQ(CsvLine({"a", "", "b c", "1,2", "say \"x\""}), "a,,b c,\"1,2\",\"say \"\"x\"\"\"\n");
}

}  // namespace
}  // namespace celt::cli
