// What is wrong is said in one line that names it, and hurts nobody else.

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "gmock/gmock.h"
#include "grpcpp/grpcpp.h"
#include "gtest/gtest.h"
#include "tests/e2e/daemon.h"

namespace celt {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

using Arguments = std::vector<std::string>;

struct Bad {
  Arguments arguments;
  int code;
  std::vector<std::string> named;  ///< in the message: the field, and the value where it has one
};

const std::vector<Bad>& BadInput() {
  static const auto& bad = *new std::vector<Bad>{
      {{"--energy", "50"}, 2, {"energy", "50"}},
      {{"--energy", "nan"}, 2, {"--energy", "nan"}},
      {{"--mass", "-1"}, 2, {"mass", "-1"}},
      {{"--mass", "0"}, 2, {"mass", "0"}},
      {{"--gravity", "-9.8"}, 2, {"gravity", "-9.8"}},
      {{"--height", "0"}, 2, {"height", "0"}},
      {{"--radii", "9,-4"}, 2, {"radius_2", "-4"}},
      {{"--inertia", "2,6,9"}, 2, {"inertia_3", "9"}},
      {{"--inertia", "0,6,7"}, 2, {"inertia_1", "0"}},
      {{"--start", "2.1,1,-0.4"}, 2, {"l_over_g", "1"}},
      {{"--start", "2.1,-0.6,-1.5"}, 2, {"h_over_g", "-1.5"}},
      {{"--start", "2,0.6,-0.8"}, 2, {"start", "gamma3"}},
      {{"--start", "2,0.7,-0.8"}, 1, {"orbit lost", "gamma3"}},
      {{"--iterates", "0"}, 2, {"iterates", "0"}},
      {{"--iterates", "1e15"}, 2, {"iterates", "1000000000000000"}},
      {{"--orbits", "0"}, 2, {"orbits", "0"}},
      {{"--orbits", "5000"}, 2, {"orbits", "5000"}},
      {{"--iterates", "7", "--orbits", "8"}, 2, {"iterates", "7"}},
      {{"--tolerance", "0"}, 2, {"tolerance", "0"}},
      {{"--tolerance", "1"}, 2, {"tolerance", "1"}},
      {{"--system", "top"}, 2, {"system", "top", "celtic-stone", "lorenz", "henon3d"}},
      {{"--system", "henon3d", "--set", "c=1"}, 2, {"c", "henon3d"}},
      {{"--system", "henon3d", "--start", "1,2"}, 2, {"x", "3"}},
      {{"--system", "henon3d", "--energy", "1"}, 2, {"--energy"}},
      {{"--system", "henon3d", "--start", "50,50,50"}, 1, {"orbit"}},
  };
  return bad;
}

const Arguments kShort = {"lyapunov", "--iterates", "20", "--orbits", "2", "--transient", "5"};

/// The arguments in place of those of the short question that they repeat.
Arguments Question(const Arguments& bad) {
  Arguments question = {"lyapunov"};
  for (std::size_t i = 1; i < kShort.size(); i += 2) {
    if (std::find(bad.begin(), bad.end(), kShort[i]) != bad.end()) continue;
    question.insert(question.end(), {kShort[i], kShort[i + 1]});
  }
  return With(question, bad);
}

void ExpectRefusal(const Bad& bad, const Ended& run) {
  EXPECT_EQ(run.code, bad.code) << run.err;
  EXPECT_THAT(run.err, StartsWith("celt: "));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  for (const std::string& word : bad.named) EXPECT_THAT(run.err, HasSubstr(word));
  EXPECT_THAT(run.out, ::testing::Not(HasSubstr("\"result\"")));
}

TEST(BadInput, IsNamedInOneLineAndTheServerGoesOn) {
  const TemporaryDirectory data;
  const Daemon daemon(data.path());
  const Celt celt;
  const Arguments server = {"--server", daemon.address()};
  for (const Bad& bad : BadInput()) {
    SCOPED_TRACE(::testing::PrintToString(bad.arguments));
    ExpectRefusal(bad, celt.Run(With(Question(bad.arguments), server)));
  }
  EXPECT_EQ(celt.Run(With(Question({"--system", "henon3d"}), server)).code, 0);
}

TEST(BadInput, IsAnsweredTheSameByTheEmbeddedService) {
  const TemporaryDirectory data;
  const Daemon daemon(data.path());
  const Celt celt;
  for (const Bad& bad : BadInput()) {
    SCOPED_TRACE(::testing::PrintToString(bad.arguments));
    if (bad.code != 2) continue;  // the message of a job that failed names the job
    const Arguments question = Question(bad.arguments);
    EXPECT_EQ(celt.Run(question).err, celt.Run(With(question, {"--server", daemon.address()})).err);
  }
}

TEST(BadInput, ThatOnlyAPlainClientCanSendIsRefusedToo) {
  const TemporaryDirectory data;
  const Daemon daemon(data.path());
  const auto stub = daemon.Connect();
  const auto refusal = [&stub](const v1::JobSpec& spec) {
    grpc::ClientContext context;
    v1::SubmitJobRequest request;
    *request.mutable_spec() = spec;
    v1::Job job;
    const grpc::Status status = stub->SubmitJob(&context, request, &job);
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    return status.error_message();
  };
  v1::JobSpec none;
  EXPECT_THAT(refusal(none), HasSubstr("analysis"));
  v1::JobSpec energy;
  energy.mutable_lyapunov();
  (*energy.mutable_system()->mutable_parameters())["energy"] =
      std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(energy), HasSubstr("energy"));
  v1::JobSpec start;
  start.mutable_lyapunov()->mutable_start()->set_l(std::numeric_limits<double>::infinity());
  start.mutable_lyapunov()->mutable_start()->set_l_over_g(-0.6);
  start.mutable_lyapunov()->mutable_start()->set_h_over_g(-0.3);
  EXPECT_THAT(refusal(start), HasSubstr("l"));
  v1::JobSpec tolerance;
  tolerance.mutable_lyapunov();
  tolerance.mutable_numerics()->set_tolerance(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT(refusal(tolerance), HasSubstr("tolerance"));
}

TEST(BadInput, ServerThatIsNotThereExitsThree) {
  std::string address;
  {
    const TemporaryDirectory data;
    address = Daemon(data.path()).address();
  }
  const Ended run = Celt().Run(With(kShort, {"--server", address}));
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, StartsWith("celt: server " + address + ": unavailable: "));
  EXPECT_EQ(run.out, "");
}

}  // namespace
}  // namespace celt
