// The same question, asked in every way there is.

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "gmock/gmock.h"
#include "google/protobuf/util/json_util.h"
#include "grpcpp/grpcpp.h"
#include "gtest/gtest.h"
#include "tests/e2e/daemon.h"

namespace celt {
namespace {

using ::testing::HasSubstr;

using Arguments = std::vector<std::string>;

struct Question {
  std::string name;
  Arguments arguments;
  v1::JobSpec spec;
};

v1::JobSpec Spectrum(const std::string& system, std::int64_t iterates, int orbits,
                     std::int64_t transient) {
  v1::JobSpec spec;
  spec.mutable_system()->set_name(system);
  spec.mutable_lyapunov()->set_iterates(iterates);
  spec.mutable_lyapunov()->set_orbits(orbits);
  spec.mutable_lyapunov()->set_transient(transient);
  return spec;
}

std::vector<Question> Questions() {
  return {{"henon3d",
           {"lyapunov", "--system", "henon3d", "--iterates", "5000", "--orbits", "5", "--transient",
            "100"},
           Spectrum("henon3d", 5000, 5, 100)},
          {"stone",
           {"lyapunov", "--system", "celtic-stone", "--iterates", "40", "--orbits", "2",
            "--transient", "5"},
           Spectrum("celtic-stone", 40, 2, 5)}};
}

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class AnswersTest : public ::testing::TestWithParam<Question> {
 protected:
  std::string Remote(const Daemon& daemon) const {
    const Ended run =
        celt_.Run(With(GetParam().arguments, {"--fresh", "--server", daemon.address()}));
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    return run.out;
  }

  std::string Embedded(const std::string& threads) const {
    const Ended run = celt_.Run(With(GetParam().arguments, {"--fresh", "--threads", threads}));
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    return run.out;
  }

  TemporaryDirectory first_;
  TemporaryDirectory second_;
  Celt celt_;
};

TEST_P(AnswersTest, SameBytesEmbeddedAndRemoteWithOneThreadAndWithTwo) {
  const Daemon one(first_.path(), 1);
  const Daemon two(second_.path(), 2);
  const std::string expected = Embedded("1");
  EXPECT_EQ(expected, Embedded("2"));
  EXPECT_EQ(expected, Remote(one));
  EXPECT_EQ(expected, Remote(two));
  ASSERT_GE(Lines(expected).size(), 2U);
  EXPECT_THAT(Lines(expected).back(), HasSubstr("{\"result\":{\"exponentsPerIterate\":["));
}

/// The stream of a job, message by message, as bytes.
std::vector<std::string> ReadStream(v1::Celt::Stub& stub, const std::string& id, std::int64_t after,
                                    std::vector<v1::StreamResultsResponse>* messages = nullptr) {
  grpc::ClientContext context;
  v1::StreamResultsRequest request;
  request.set_id(id);
  request.set_after_sequence(after);
  const auto reader = stub.StreamResults(&context, request);
  std::vector<std::string> bytes;
  for (v1::StreamResultsResponse message; reader->Read(&message);) {
    bytes.push_back(message.SerializeAsString());
    if (messages != nullptr) messages->push_back(message);
  }
  const grpc::Status status = reader->Finish();
  EXPECT_TRUE(status.ok()) << status.error_message();
  return bytes;
}

std::string Json(const google::protobuf::Message& message) {
  std::string json;
  EXPECT_TRUE(google::protobuf::util::MessageToJsonString(message, &json).ok());
  return json;
}

TEST_P(AnswersTest, PlainClientGetsWhatTheCommandLinePrints) {
  const Daemon daemon(first_.path());
  const auto stub = daemon.Connect();
  grpc::ClientContext context;
  v1::SubmitJobRequest request;
  *request.mutable_spec() = GetParam().spec;
  v1::Job job;
  ASSERT_TRUE(stub->SubmitJob(&context, request, &job).ok());

  std::vector<v1::StreamResultsResponse> messages;
  const auto live = ReadStream(*stub, job.id(), 0, &messages);
  ASSERT_GE(messages.size(), 2U);
  const std::vector<std::string> printed = Lines(Remote(daemon));
  ASSERT_EQ(printed.size(), messages.size());
  for (std::size_t i = 0; i + 1 < messages.size(); ++i) {
    EXPECT_EQ(printed[i], Json(messages[i].record()));
  }
  EXPECT_EQ(printed.back(), "{\"result\":" + Json(messages.back().result().lyapunov()) + "}");

  EXPECT_EQ(ReadStream(*stub, job.id(), 0), live) << "afterwards as live";
  const std::int64_t after = messages.front().record().sequence();
  EXPECT_EQ(ReadStream(*stub, job.id(), after),
            std::vector<std::string>(live.begin() + 1, live.end()));
}

INSTANTIATE_TEST_SUITE_P(Systems, AnswersTest, ::testing::ValuesIn(Questions()),
                         [](const auto& question) { return question.param.name; });

TEST(Answers, SumOfTheHenonMapIsTheLogarithmOfItsDeterminant) {
  const Celt celt;
  const Ended run = celt.Run({"lyapunov", "--system", "henon3d", "--set", "b=0.7", "--iterates",
                              "1000", "--orbits", "2", "--transient", "10"});
  ASSERT_EQ(run.code, 0) << run.err;
  // ln 0.7 to the digits before the rounding of a thousand sums can show.
  EXPECT_THAT(run.out, HasSubstr("\"sumPerIterate\":-0.3566749439387"));
}

TEST(Answers, OtherSeedOtherDigits) {
  const Celt celt;
  const Arguments question = {"lyapunov", "--system", "henon3d", "--iterates", "1000"};
  EXPECT_NE(celt.Run(With(question, {"--seed", "1"})).out,
            celt.Run(With(question, {"--seed", "2"})).out);
}

}  // namespace
}  // namespace celt
