#include "server/daemon/host_options.h"

#include "gtest/gtest.h"

namespace celt::daemon {
namespace {

TEST(HostOptions, AreWhatTheConfigurationSays) {
  config::Config config;
  config.limits.nodes = 7;
  config.limits.computing_hours = 0.5;
  config.limits.unfinished_jobs_per_owner = 3;
  config.retention.record_days = 2;
  config.retention.job_days = 0.5;
  config.retention.store_megabytes = 3;
  config.store.synchronous = "full";
  const host::HostOptions options = HostOptionsOf(config);
  EXPECT_EQ(options.spec_limits.nodes, 7);
  EXPECT_EQ(options.job_limits.computing_time, absl::Minutes(30));
  EXPECT_EQ(options.job_limits.unfinished_per_owner, 3);
  EXPECT_EQ(options.retention.records, absl::Hours(48));
  EXPECT_EQ(options.retention.jobs, absl::Hours(12));
  EXPECT_EQ(options.retention.bytes, 3 << 20);
  EXPECT_EQ(options.synchronous, jobs::Synchronous::kFull);
}

TEST(HostOptions, HaveNoLimitWhereTheConfigurationHas0) {
  config::Config config;
  config.limits = {.iterates = 0,
                   .nodes = 0,
                   .records = 0,
                   .computing_hours = 0,
                   .unfinished_jobs = 0,
                   .unfinished_jobs_per_owner = 0};
  const host::HostOptions options = HostOptionsOf(config);
  EXPECT_EQ(options.spec_limits.iterates, plans::SpecLimits::kNone);
  EXPECT_EQ(options.spec_limits.nodes, plans::SpecLimits::kNone);
  EXPECT_EQ(options.job_limits.records, jobs::JobLimits::kNone);
  EXPECT_EQ(options.job_limits.unfinished, jobs::JobLimits::kNone);
  EXPECT_EQ(options.job_limits.unfinished_per_owner, jobs::JobLimits::kNone);
  EXPECT_EQ(options.job_limits.computing_time, absl::InfiniteDuration());
  EXPECT_EQ(options.retention.records, absl::InfiniteDuration());
  EXPECT_EQ(options.retention.jobs, absl::InfiniteDuration());
  EXPECT_EQ(options.synchronous, jobs::Synchronous::kNormal);
}

}  // namespace
}  // namespace celt::daemon
