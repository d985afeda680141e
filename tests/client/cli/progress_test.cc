#include "client/cli/progress.h"

#include "gtest/gtest.h"

namespace celt::cli {
namespace {

v1::Job RunningJob(double done, double total) {
  v1::Job job;
  job.set_state(v1::Job::STATE_RUNNING);
  job.mutable_progress()->set_done(done);
  job.mutable_progress()->set_total(total);
  job.mutable_progress()->set_unit("iterates");
  return job;
}

const absl::Time kStart = absl::FromUnixSeconds(1000);

TEST(ProgressMeter, ShowsRateAndTimeLeftFromTheSecondMeasurementOn) {
  ProgressMeter meter;
  EXPECT_EQ(meter.Line(RunningJob(0, 20000), kStart), "[------------------------]   0%");
  EXPECT_EQ(meter.Line(RunningJob(5000, 20000), kStart + absl::Seconds(4)),
            "[######------------------]  25%  1 250 iterates/s  0:12 left");
}

TEST(ProgressMeter, CountsFromWhereItFoundTheJob) {
  ProgressMeter meter;
  static_cast<void>(meter.Line(RunningJob(10000, 20000), kStart));
  EXPECT_EQ(meter.Line(RunningJob(10010, 20000), kStart + absl::Seconds(1)),
            "[############------------]  50%  10 iterates/s  16:39 left");
}

TEST(ProgressMeter, FollowsAChangeOfRate) {
  ProgressMeter meter;
  static_cast<void>(meter.Line(RunningJob(0, 1e6), kStart));
  static_cast<void>(meter.Line(RunningJob(1000, 1e6), kStart + absl::Seconds(1)));
  // After a hundred seconds, many times the memory of the mean, only the new rate is left.
  const std::string line = meter.Line(RunningJob(21000, 1e6), kStart + absl::Seconds(101));
  EXPECT_NE(line.find(" 200 iterates/s"), std::string::npos) << line;
}

TEST(ProgressMeter, NeverPromisesMoreThanIsDone) {
  ProgressMeter meter;
  EXPECT_EQ(meter.Line(RunningJob(19999, 20000), kStart), "[#######################-]  99%");
  EXPECT_EQ(meter.Line(RunningJob(3, 0), kStart), "[------------------------]   0%");
}

TEST(ProgressMeter, QueuedJobWaits) {
  v1::Job job;
  job.set_state(v1::Job::STATE_QUEUED);
  EXPECT_EQ(ProgressMeter().Line(job, kStart), "waiting for a worker");
}

}  // namespace
}  // namespace celt::cli
