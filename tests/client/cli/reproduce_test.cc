#include "client/cli/reproduce.h"

#include "client/cli/json.h"
#include "gtest/gtest.h"
#include "tests/client/fake_service.h"
#include "tests/client/run_celt.h"

namespace celt::cli {
namespace {

v1::Record RowRecord() {
  v1::Record record;
  record.set_sequence(2);
  v1::ReproduceRecord& row = *record.mutable_reproduce();
  row.set_section("3.3, 1");
  row.set_quantity("O*: λ1");
  row.set_paper("0.996");
  row.set_computed("0.96606");
  row.set_error(1e-5);
  row.set_verdict(v1::DIFFERS);
  row.set_remark("a misprint");
  return record;
}

TEST(ReproduceTable, HasALineForEachRowAndOneForItsRemark) {
  EXPECT_EQ(MakeReproduce()->Line(RowRecord()),
            "  ✗  3.3, 1  O*: λ1" + std::string(46, ' ') + "0.996" + std::string(15, ' ') +
                "0.96606 ± 1e-05\n" + std::string(13, ' ') + "  a misprint\n");
}

TEST(ReproduceCsv, HasTheRow) {
  const CsvRow expected = {{"section", "3.3, 1"},   {"quantity", "O*: λ1"}, {"paper", "0.996"},
                           {"computed", "0.96606"}, {"error", "1e-05"},     {"verdict", "DIFFERS"},
                           {"remark", "a misprint"}};
  EXPECT_EQ(MakeReproduce()->Csv(RowRecord()), expected);
}

TEST(ReproduceOptions, QuickIsSent) {
  FakeService service;
  v1::StreamResultsResponse result;
  result.mutable_result()->mutable_reproduce()->set_agree(3);
  service.scripts = {{{result}, {}}};
  const Outcome outcome =
      RunCelt({"reproduce", "--quick", "--output", "table"}, {.server = service.address()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "\n3 rows agree or hold, 0 do not\n");
  EXPECT_EQ(ToJson(service.submitted()), R"({"reproduce":{"quick":true}})");
}

}  // namespace
}  // namespace celt::cli
