#include "server/api/celt_service.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "host/host_testing.h"
#include "server/api/error_details.pb.h"
#include "server/plans/engine_version.h"

namespace celt::host {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class CeltServiceTest : public ::testing::Test {
 protected:
  std::unique_ptr<Host> host_ = StartHost();
  std::unique_ptr<Stub> stub_ = v1::Celt::NewStub(host_->InProcessChannel());

  v1::ListJobsResponse List(const v1::ListJobsRequest& request) {
    grpc::ClientContext context;
    v1::ListJobsResponse response;
    const grpc::Status status = stub_->ListJobs(&context, request, &response);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return response;
  }
  grpc::StatusCode ListCode(const v1::ListJobsRequest& request) {
    grpc::ClientContext context;
    v1::ListJobsResponse response;
    return stub_->ListJobs(&context, request, &response).error_code();
  }
};

TEST_F(CeltServiceTest, AcceptsAJobWithItsDefaultsFilledIn) {
  const v1::Job job = Submit(*stub_, kShort);
  EXPECT_THAT(job.id(), SizeIs(12));
  EXPECT_EQ(job.state(), v1::Job::STATE_QUEUED);
  EXPECT_EQ(job.spec().lyapunov().seed(), 1U);
  EXPECT_EQ(job.progress().total(), 25640);
  EXPECT_EQ(job.progress().unit(), "iterates");
  EXPECT_GT(job.create_time().seconds(), 0);
  EXPECT_FALSE(job.has_start_time());
}

TEST_F(CeltServiceTest, EstimatesAJobAsLongAsItHasNotEnded) {
  const v1::Job endless = Submit(*stub_, kEndless);
  EXPECT_EQ(endless.estimate().iterates(), 1e12);
  EXPECT_GT(endless.estimate().most_units(), 1'000'000);
  EXPECT_GT(endless.estimate().seconds(), 1000) << "nothing computes 10^9 iterates in a second";
  EXPECT_EQ(endless.estimate().queue_seconds(), 0);
  const v1::Job next = Submit(*stub_, kShort);
  EXPECT_GT(next.estimate().queue_seconds(), 1000) << "of the endless one";
  v1::Job job;
  ASSERT_TRUE(Get(*stub_, endless.id(), &job).ok());
  EXPECT_TRUE(job.has_estimate());
  Cancel(*stub_, endless.id());
  WatchToTheEnd(*stub_, endless.id());
  ASSERT_TRUE(Get(*stub_, endless.id(), &job).ok());
  EXPECT_FALSE(job.has_estimate());
}

TEST_F(CeltServiceTest, OnlyValidatesARequestThatSaysSo) {
  v1::SubmitJobRequest request = Request(kEndless, "request");
  request.set_validate_only(true);
  grpc::ClientContext context;
  v1::Job job;
  ASSERT_TRUE(stub_->SubmitJob(&context, request, &job).ok());
  EXPECT_EQ(job.id(), "");
  EXPECT_EQ(job.spec().lyapunov().seed(), 1U) << "defaults are filled in";
  EXPECT_EQ(job.estimate().iterates(), 1e12);
  EXPECT_EQ(List({}).jobs_size(), 0);
  request.mutable_spec()->mutable_lyapunov()->set_iterates(0);
  grpc::ClientContext wrong;
  EXPECT_EQ(stub_->SubmitJob(&wrong, request, &job).error_code(),
            grpc::StatusCode::INVALID_ARGUMENT);
}

TEST_F(CeltServiceTest, ValidationNamesTheJobThatHasGivenTheAnswerUnlessItIsToBeFresh) {
  const std::string id = Submit(*stub_, kShort).id();
  WatchToTheEnd(*stub_, id);
  v1::SubmitJobRequest request = Request(kShort);
  request.set_validate_only(true);
  request.set_fresh(false);
  v1::Job job;
  grpc::ClientContext known;
  ASSERT_TRUE(stub_->SubmitJob(&known, request, &job).ok());
  EXPECT_EQ(job.id(), id);
  EXPECT_EQ(job.state(), v1::Job::STATE_SUCCEEDED);
  EXPECT_FALSE(job.has_estimate());
  request.set_fresh(true);
  grpc::ClientContext fresh;
  ASSERT_TRUE(stub_->SubmitJob(&fresh, request, &job).ok());
  EXPECT_EQ(job.id(), "");
  EXPECT_TRUE(job.has_estimate());
}

TEST_F(CeltServiceTest, RefusesAWrongSpecificationByItsField) {
  const grpc::Status status = TrySubmit(*stub_, "lyapunov { iterates: 0 }");
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_THAT(status.error_message(), HasSubstr("iterates: 0 is not allowed"));
  EXPECT_EQ(List({}).jobs_size(), 0);
}

TEST_F(CeltServiceTest, WatchesAJobToItsEnd) {
  const std::string id = Submit(*stub_, kShort).id();
  const std::vector<v1::Job> jobs = WatchToTheEnd(*stub_, id);
  ASSERT_FALSE(jobs.empty());
  const v1::Job& last = jobs.back();
  EXPECT_EQ(last.state(), v1::Job::STATE_SUCCEEDED);
  EXPECT_EQ(last.progress().done(), last.progress().total());
  EXPECT_EQ(last.last_sequence(), 64);
  EXPECT_TRUE(last.has_start_time());
  EXPECT_TRUE(last.has_end_time());
  for (std::size_t i = 1; i < jobs.size(); ++i) {
    EXPECT_LE(jobs[i - 1].progress().done(), jobs[i].progress().done());
  }
  EXPECT_THAT(WatchToTheEnd(*stub_, id), SizeIs(1)) << "one that ended is told once";
}

TEST_F(CeltServiceTest, StreamsTheSameLiveAndAfterwards) {
  const std::string id = Submit(*stub_, kShort).id();
  Results live(*stub_, id);
  EXPECT_TRUE(live.ReadAll().ok());
  ASSERT_THAT(live.messages, SizeIs(65));
  for (int i = 0; i < 64; ++i) EXPECT_EQ(live.messages[i].record().sequence(), i + 1);
  EXPECT_EQ(live.messages.back().result().lyapunov().iterates(), 25600);
  Results afterwards(*stub_, id);
  EXPECT_TRUE(afterwards.ReadAll().ok());
  EXPECT_EQ(afterwards.Bytes(), live.Bytes());
}

TEST_F(CeltServiceTest, StreamsFromAnySequenceNumber) {
  const std::string id = Submit(*stub_, kShort).id();
  WatchToTheEnd(*stub_, id);
  Results all(*stub_, id);
  EXPECT_TRUE(all.ReadAll().ok());
  const std::vector<std::string> bytes = all.Bytes();
  for (const int after : {1, 63, 64, 1000}) {
    Results rest(*stub_, id, after);
    EXPECT_TRUE(rest.ReadAll().ok());
    const std::vector<std::string> expected(bytes.begin() + std::min(after, 64), bytes.end());
    EXPECT_EQ(rest.Bytes(), expected) << "after " << after;
  }
}

TEST_F(CeltServiceTest, GivesTheSameBytesForTheSameSpecification) {
  Results first(*stub_, Submit(*stub_, kShort).id());
  Results second(*stub_, Submit(*stub_, kShort).id());
  EXPECT_TRUE(first.ReadAll().ok());
  EXPECT_TRUE(second.ReadAll().ok());
  EXPECT_EQ(first.Bytes(), second.Bytes());
}

TEST_F(CeltServiceTest, CancelsAndEndsItsStreams) {
  const std::string id = Submit(*stub_, kEndless).id();
  Results results(*stub_, id);
  v1::Job job;
  // Running by the time that the cancellation comes, or not: it makes no difference to what is
  // promised.
  const v1::Job cancelled = Cancel(*stub_, id);
  EXPECT_TRUE(cancelled.state() == v1::Job::STATE_CANCELLED ||
              cancelled.state() == v1::Job::STATE_RUNNING ||
              cancelled.state() == v1::Job::STATE_QUEUED);
  EXPECT_EQ(WatchToTheEnd(*stub_, id).back().state(), v1::Job::STATE_CANCELLED);
  EXPECT_EQ(results.ReadAll().error_code(), grpc::StatusCode::ABORTED);
  EXPECT_EQ(Cancel(*stub_, id).state(), v1::Job::STATE_CANCELLED);
}

TEST_F(CeltServiceTest, EndsTheStreamOfAFailedJobWithItsError) {
  const std::string id = Submit(*stub_, kLost).id();
  Results results(*stub_, id);
  const grpc::Status status = results.ReadAll();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::FAILED_PRECONDITION);
  v1::Job job;
  ASSERT_TRUE(Get(*stub_, id, &job).ok());
  EXPECT_EQ(job.state(), v1::Job::STATE_FAILED);
  EXPECT_EQ(job.error().code(), static_cast<int>(grpc::StatusCode::OUT_OF_RANGE));
  EXPECT_THAT(status.error_message(), HasSubstr(job.error().message()));
}

TEST_F(CeltServiceTest, DeletesARunningJobAndEndsItsStreams) {
  const std::string id = Submit(*stub_, kEndless).id();
  Results results(*stub_, id);
  EXPECT_TRUE(Delete(*stub_, id).ok());
  EXPECT_EQ(results.ReadAll().error_code(), grpc::StatusCode::NOT_FOUND);
  v1::Job job;
  EXPECT_EQ(Get(*stub_, id, &job).error_code(), grpc::StatusCode::NOT_FOUND);
}

TEST_F(CeltServiceTest, KnowsNoJobThatIsNotThere) {
  const std::string id = "nobody";
  v1::Job job;
  EXPECT_EQ(Get(*stub_, id, &job).error_code(), grpc::StatusCode::NOT_FOUND);
  EXPECT_EQ(Delete(*stub_, id).error_code(), grpc::StatusCode::NOT_FOUND);
  EXPECT_EQ(Results(*stub_, id).ReadAll().error_code(), grpc::StatusCode::NOT_FOUND);
  grpc::ClientContext cancel;
  EXPECT_EQ(stub_->CancelJob(&cancel, {}, &job).error_code(), grpc::StatusCode::NOT_FOUND);
  grpc::ClientContext watch;
  EXPECT_EQ(stub_->WatchJob(&watch, {})->Finish().error_code(), grpc::StatusCode::NOT_FOUND);
}

TEST_F(CeltServiceTest, AnswersALongIdBriefly) {
  v1::Job job;
  const grpc::Status status = Get(*stub_, std::string(500'000, 'x'), &job);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::NOT_FOUND);
}

TEST_F(CeltServiceTest, TakesARequestOnce) {
  const std::string id = Submit(*stub_, kShort, "r").id();
  EXPECT_EQ(Submit(*stub_, kShort, "r").id(), id);
  EXPECT_EQ(TrySubmit(*stub_, kLost, "r").error_code(), grpc::StatusCode::ALREADY_EXISTS);
  EXPECT_EQ(TrySubmit(*stub_, kShort, std::string(65, 'r')).error_code(),
            grpc::StatusCode::INVALID_ARGUMENT);
}

TEST_F(CeltServiceTest, NamesTheJobThatIsInTheWayOfARequest) {
  const std::string id = Submit(*stub_, kShort, "r").id();
  google::rpc::Status details;
  const grpc::Status status = TrySubmit(*stub_, kLost, "r");
  ASSERT_TRUE(details.ParseFromString(status.error_details()));
  google::rpc::ResourceInfo resource;
  ASSERT_EQ(details.details_size(), 1);
  ASSERT_TRUE(details.details(0).UnpackTo(&resource));
  EXPECT_EQ(resource.resource_name(), id);
}

TEST_F(CeltServiceTest, GivesAKnownAnswerAtOnceUnlessAFreshOneIsAskedFor) {
  const v1::Job computed = Submit(*stub_, kShort);
  WatchToTheEnd(*stub_, computed.id());
  v1::SubmitJobRequest request = Request(kShort);
  request.set_fresh(false);
  grpc::ClientContext context;
  v1::Job known;
  ASSERT_TRUE(stub_->SubmitJob(&context, request, &known).ok());
  EXPECT_EQ(known.id(), computed.id());
  EXPECT_EQ(known.state(), v1::Job::STATE_SUCCEEDED);
  EXPECT_NE(Submit(*stub_, kShort).id(), computed.id());
}

TEST_F(CeltServiceTest, ListsJobsPageByPage) {
  std::vector<std::string> ids;
  for (int i = 0; i < 3; ++i) ids.push_back(Submit(*stub_, kShort).id());
  v1::ListJobsRequest request;
  request.set_page_size(2);
  const v1::ListJobsResponse first = List(request);
  ASSERT_EQ(first.jobs_size(), 2);
  EXPECT_EQ(first.jobs(0).id(), ids[2]);
  EXPECT_EQ(first.jobs(1).id(), ids[1]);
  request.set_page_token(first.next_page_token());
  const v1::ListJobsResponse second = List(request);
  ASSERT_EQ(second.jobs_size(), 1);
  EXPECT_EQ(second.jobs(0).id(), ids[0]);
  EXPECT_EQ(second.next_page_token(), "");
}

TEST_F(CeltServiceTest, ListsTheStatesAskedFor) {
  const std::string lost = Submit(*stub_, kLost).id();
  WatchToTheEnd(*stub_, lost);
  WatchToTheEnd(*stub_, Submit(*stub_, kShort).id());
  v1::ListJobsRequest request;
  request.add_states(v1::Job::STATE_FAILED);
  const v1::ListJobsResponse failed = List(request);
  ASSERT_EQ(failed.jobs_size(), 1);
  EXPECT_EQ(failed.jobs(0).id(), lost);
}

TEST_F(CeltServiceTest, RefusesWrongLists) {
  v1::ListJobsRequest request;
  request.set_page_size(-1);
  EXPECT_EQ(ListCode(request), grpc::StatusCode::INVALID_ARGUMENT);
  request.set_page_size(1001);
  EXPECT_EQ(ListCode(request), grpc::StatusCode::INVALID_ARGUMENT);
  request.set_page_size(1);
  request.set_page_token("nonsense");
  EXPECT_EQ(ListCode(request), grpc::StatusCode::INVALID_ARGUMENT);
  request.clear_page_token();
  request.add_states(v1::Job::STATE_UNSPECIFIED);
  EXPECT_EQ(ListCode(request), grpc::StatusCode::INVALID_ARGUMENT);
  request.set_states(0, static_cast<v1::Job::State>(9));
  EXPECT_EQ(ListCode(request), grpc::StatusCode::INVALID_ARGUMENT);
}

TEST_F(CeltServiceTest, TellsWhatThereIs) {
  grpc::ClientContext context;
  v1::GetInfoResponse info;
  ASSERT_TRUE(stub_->GetInfo(&context, {}, &info).ok());
  EXPECT_EQ(info.workers(), 2);
  EXPECT_FALSE(info.version().empty());
  std::vector<std::string> names;
  for (const v1::SystemInfo& system : info.systems()) {
    names.push_back(system.name());
    EXPECT_EQ(system.coordinates_size(), 3);
  }
  EXPECT_THAT(names, ElementsAre("celtic-stone", "lorenz", "henon3d"));
  const v1::ParameterInfo& energy = info.systems(0).parameters(0);
  EXPECT_EQ(energy.name(), "energy");
  EXPECT_EQ(energy.default_value(), 752);
  EXPECT_EQ(energy.range(), "(-inf, inf)");
  EXPECT_EQ(info.engine_version(), plans::kEngineVersion);
  EXPECT_THAT(info.analyses(), Contains("sweep"));
  EXPECT_THAT(info.engines(), ElementsAre(v1::ENGINE_CVODE, v1::ENGINE_ARKODE, v1::ENGINE_FAST));
  EXPECT_EQ(info.limits().SerializeAsString(), "") << "there are none";
}

}  // namespace
}  // namespace celt::host
