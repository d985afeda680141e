// The load test in small: celt_load is the large one.

#include "tests/load/load.h"

#include "gtest/gtest.h"

namespace celt::load {
namespace {

TEST(Load, HurtsNobody) {
  Options options;
  options.clients = 20;
  options.jobs_each = 2;
  options.stalled = 10;
  options.dropped = 50;
  options.timed = 5;
  const Report report = load::Run(options);
  EXPECT_EQ(report.errors, 0) << report.first_error;
  EXPECT_EQ(report.lost_records, 0);
  EXPECT_EQ(report.jobs, 50);
  // Of a sanitizer's shadow nothing is promised.
#ifndef CELT_SANITIZED
  EXPECT_LT(report.peak_megabytes, 200);
#endif
}

}  // namespace
}  // namespace celt::load
