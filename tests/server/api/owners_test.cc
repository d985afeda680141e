// Jobs belong to their owner: another one learns nothing of them.

#include <fstream>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "host/host_testing.h"
#include "server/auth/tokens.h"
#include "temporary_directory.h"

namespace celt::host {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// The service as one owner sees it.
class Caller {
 public:
  Caller(Host& host, std::string token)
      : stub_(v1::Celt::NewStub(host.InProcessChannel())), token_(std::move(token)) {}

  void Show(grpc::ClientContext& context) const {
    if (!token_.empty()) context.AddMetadata("authorization", "Bearer " + token_);
  }
  grpc::Status Submit(const std::string& spec, v1::Job* job,
                      const std::string& request = "") const {
    grpc::ClientContext context;
    Show(context);
    return stub_->SubmitJob(&context, Request(spec, request), job);
  }
  /// What each call that names a job says of it.
  std::vector<grpc::Status> AskEverythingAbout(const std::string& id) const {
    std::vector<grpc::Status> answers;
    const auto ask = [&](auto request, auto call) {
      grpc::ClientContext context;
      Show(context);
      request.set_id(id);
      answers.push_back(call(&context, request));
    };
    v1::Job job;
    v1::DeleteJobResponse deleted;
    ask(v1::GetJobRequest(), [&](auto* c, auto& r) { return stub_->GetJob(c, r, &job); });
    ask(v1::CancelJobRequest(), [&](auto* c, auto& r) { return stub_->CancelJob(c, r, &job); });
    ask(v1::DeleteJobRequest(), [&](auto* c, auto& r) { return stub_->DeleteJob(c, r, &deleted); });
    ask(v1::WatchJobRequest(), [&](auto* c, auto& r) { return stub_->WatchJob(c, r)->Finish(); });
    ask(v1::StreamResultsRequest(),
        [&](auto* c, auto& r) { return stub_->StreamResults(c, r)->Finish(); });
    return answers;
  }
  std::vector<std::string> List() const {
    grpc::ClientContext context;
    Show(context);
    v1::ListJobsResponse response;
    EXPECT_TRUE(stub_->ListJobs(&context, {}, &response).ok());
    std::vector<std::string> owners;
    for (const v1::Job& job : response.jobs()) owners.push_back(job.owner());
    return owners;
  }

 private:
  std::unique_ptr<Stub> stub_;
  std::string token_;
};

class OwnersTest : public ::testing::Test {
 protected:
  OwnersTest() {
    std::ofstream file(temporary_ / "tokens");
    file << auth::TokenLine({"anna", false}, "a") << "\n"
         << auth::TokenLine({"boris", false}, "b") << "\n"
         << auth::TokenLine({"root", true}, "r") << "\n";
    file.close();
    HostOptions options;
    options.workers = 1;
    options.keys.tokens = temporary_ / "tokens";
    options.on_call = [this](const api::CallDone& call) {
      const std::lock_guard lock(mutex_);
      calls_.push_back(std::string(call.method) + " " + call.request + " " + call.owner);
    };
    auto host = Host::Start(options);
    EXPECT_TRUE(host.ok()) << host.status();
    host_ = *std::move(host);
  }

  TemporaryDirectory temporary_;
  std::mutex mutex_;
  std::vector<std::string> calls_;
  std::unique_ptr<Host> host_;
};

TEST_F(OwnersTest, AnotherOwnerLearnsNotEvenThatAJobExists) {
  v1::Job job;
  ASSERT_TRUE(Caller(*host_, "a").Submit(kEndless, &job).ok());
  EXPECT_EQ(job.owner(), "anna");
  const Caller boris(*host_, "b");
  const auto of_annas = boris.AskEverythingAbout(job.id());
  const auto of_none = boris.AskEverythingAbout("0123456789ab");
  ASSERT_EQ(of_annas.size(), of_none.size());
  for (std::size_t i = 0; i < of_annas.size(); ++i) {
    EXPECT_EQ(of_annas[i].error_code(), grpc::StatusCode::NOT_FOUND) << i;
    std::string message = of_none[i].error_message();
    message.replace(message.find("0123456789ab"), 12, job.id());
    EXPECT_EQ(of_annas[i].error_message(), message) << i;
  }
  EXPECT_THAT(boris.List(), IsEmpty());
  EXPECT_THAT(Caller(*host_, "a").List(), ElementsAre("anna"));
}

TEST_F(OwnersTest, AnAdministratorSeesAllJobs) {
  v1::Job job;
  ASSERT_TRUE(Caller(*host_, "a").Submit(kShort, &job).ok());
  ASSERT_TRUE(Caller(*host_, "b").Submit(kShort, &job).ok());
  EXPECT_THAT(Caller(*host_, "r").List(), ElementsAre("boris", "anna"));
  EXPECT_TRUE(Caller(*host_, "r").AskEverythingAbout(job.id()).front().ok());
}

TEST_F(OwnersTest, ARequestOfAnotherOwnerIsAnotherRequest) {
  v1::Job annas;
  v1::Job boriss;
  ASSERT_TRUE(Caller(*host_, "a").Submit(kShort, &annas, "request").ok());
  ASSERT_TRUE(Caller(*host_, "b").Submit(kLost, &boriss, "request").ok());
  EXPECT_NE(annas.id(), boriss.id());
}

TEST_F(OwnersTest, WithoutATokenNothingIsAnswered) {
  v1::Job job;
  ASSERT_TRUE(Caller(*host_, "a").Submit(kEndless, &job).ok());
  for (const char* token : {"", "wrong"}) {
    const Caller nobody(*host_, token);
    EXPECT_EQ(nobody.Submit(kShort, &job).error_code(), grpc::StatusCode::UNAUTHENTICATED);
    for (const grpc::Status& answer : nobody.AskEverythingAbout(job.id())) {
      EXPECT_EQ(answer.error_code(), grpc::StatusCode::UNAUTHENTICATED);
    }
  }
}

TEST_F(OwnersTest, EveryCallIsToldWithItsRequestAndItsOwner) {
  const auto stub = v1::Celt::NewStub(host_->InProcessChannel());
  grpc::ClientContext context;
  context.AddMetadata("authorization", "Bearer a");
  context.AddMetadata("x-request-id", "request-7");
  v1::GetInfoResponse info;
  ASSERT_TRUE(stub->GetInfo(&context, {}, &info).ok());
  const auto echoed = context.GetServerInitialMetadata().find("x-request-id");
  ASSERT_NE(echoed, context.GetServerInitialMetadata().end());
  EXPECT_EQ(std::string(echoed->second.data(), echoed->second.size()), "request-7");
  const std::lock_guard lock(mutex_);
  EXPECT_THAT(calls_, ElementsAre("GetInfo request-7 anna"));
}

}  // namespace
}  // namespace celt::host
