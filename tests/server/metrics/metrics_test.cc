#include "server/metrics/metrics.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "httplib.h"
#include "server/metrics/http.h"

namespace celt::metrics {
namespace {

using ::testing::HasSubstr;

TEST(Metrics, TellWhatWasCounted) {
  Metrics metrics;
  metrics.CountCall("GetJob", absl::StatusCode::kNotFound, absl::Milliseconds(2));
  metrics.CountUnit(absl::Milliseconds(200), 1000, "iterates");
  metrics.CountUnit(absl::Milliseconds(200), 500, "iterates");
  const std::string text = metrics.Text({.jobs = {{"running", 2}},
                                         .active_jobs = 3,
                                         .streams = 4,
                                         .store_bytes = 4096,
                                         .store_synchronous = 2,
                                         .paces = {{"lyapunov/henon3d", 0.5}}});
  for (const char* line :
       {"celt_calls_total{code=\"NOT_FOUND\",method=\"GetJob\"} 1\n",
        "celt_call_seconds_bucket{method=\"GetJob\",le=\"0.003\"} 1\n",
        "celt_unit_seconds_count 2\n", "celt_work_total{unit=\"iterates\"} 1500\n",
        "celt_store_errors_total 0\n", "celt_jobs{state=\"running\"} 2\n", "celt_active_jobs 3\n",
        "celt_streams 4\n", "celt_store_bytes 4096\n", "celt_store_synchronous 2\n",
        "celt_pace_seconds{kind=\"lyapunov/henon3d\"} 0.5\n"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
}

TEST(HttpServer, AnswersPrometheusAndProbes) {
  std::atomic<bool> ready = true;
  const auto server = HttpServer::Start(
      "127.0.0.1:0", {.metrics = [] { return "a 1\n"; }, .ready = [&] { return ready.load(); }});
  ASSERT_TRUE(server.ok()) << server.status();
  httplib::Client client("http://" + (*server)->address());
  EXPECT_EQ(client.Get("/metrics")->body, "a 1\n");
  EXPECT_EQ(client.Get("/readyz")->status, 200);
  ready = false;
  EXPECT_EQ(client.Get("/readyz")->status, 503);
  EXPECT_EQ(client.Get("/livez")->status, 200) << "alive, though not ready";
  EXPECT_EQ(client.Get("/")->status, 404);
}

TEST(HttpServer, RefusesAPortInUse) {
  const Pages pages = {.metrics = [] { return ""; }, .ready = [] { return true; }};
  const auto first = HttpServer::Start("127.0.0.1:0", pages);
  ASSERT_TRUE(first.ok());
  const auto second = HttpServer::Start((*first)->address(), pages);
  EXPECT_EQ(second.status().code(), absl::StatusCode::kFailedPrecondition) << second.status();
}

}  // namespace
}  // namespace celt::metrics
