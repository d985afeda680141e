#include "server/jobs/notifier.h"

#include <memory>

#include "gtest/gtest.h"

namespace celt::jobs {
namespace {

TEST(Notifier, CallsAllOfTheJobAndNobodyElse) {
  Notifier notifier;
  int a = 0;
  int b = 0;
  int other = 0;
  const auto first = notifier.Subscribe("job", [&] { ++a; });
  const auto second = notifier.Subscribe("job", [&] { ++b; });
  const auto third = notifier.Subscribe("another", [&] { ++other; });
  notifier.Notify("job");
  notifier.Notify("unknown");
  EXPECT_EQ(a, 1);
  EXPECT_EQ(b, 1);
  EXPECT_EQ(other, 0);
}

TEST(Notifier, ForgetsASubscriptionThatEnded) {
  Notifier notifier;
  int calls = 0;
  auto subscription = notifier.Subscribe("job", [&] { ++calls; });
  Notifier::Subscription moved = std::move(subscription);
  notifier.Notify("job");
  moved.End();
  notifier.Notify("job");
  EXPECT_EQ(calls, 1);
}

TEST(Notifier, LetsACallbackEndItsOwnSubscription) {
  Notifier notifier;
  Notifier::Subscription subscription;
  int calls = 0;
  subscription = notifier.Subscribe("job", [&] {
    ++calls;
    subscription.End();
  });
  notifier.Notify("job");
  notifier.Notify("job");
  EXPECT_EQ(calls, 1);
}

TEST(Notifier, LetsGoOfWhatACallbackHolds) {
  Notifier notifier;
  auto held = std::make_shared<int>(0);
  auto subscription = notifier.Subscribe("job", [held] {});
  EXPECT_EQ(held.use_count(), 2);
  subscription.End();
  EXPECT_EQ(held.use_count(), 1);
}

}  // namespace
}  // namespace celt::jobs
