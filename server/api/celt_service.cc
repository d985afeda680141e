#include "server/api/celt_service.h"

#include <memory>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/api/messages.h"
#include "server/api/result_stream.h"
#include "server/api/status.h"
#include "server/api/watch_stream.h"
#include "server/jobs/status_macros.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"

namespace celt::api {
namespace {

constexpr std::size_t kLongestRequestId = 64;
constexpr int kDefaultPage = 50;
constexpr int kLargestPage = 1000;

grpc::ServerUnaryReactor* Answer(grpc::CallbackServerContext* context, const absl::Status& status) {
  grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
  reactor->Finish(ToGrpc(status));
  return reactor;
}

template <class Message>
grpc::ServerUnaryReactor* Answer(grpc::CallbackServerContext* context,
                                 absl::StatusOr<Message> answer, Message* response) {
  const absl::Status status = answer.status();
  if (answer.ok()) *response = *std::move(answer);
  return Answer(context, status);
}

absl::StatusOr<v1::Job> ToAnswer(const absl::StatusOr<jobs::Job>& job) {
  if (!job.ok()) return job.status();
  return ToMessage(*job);
}

}  // namespace

void CeltService::EndStreams() {
  streams_.EndAll(absl::UnavailableError("the server is shutting down; come back later"));
}

absl::StatusOr<v1::Job> CeltService::Submit(const v1::SubmitJobRequest& request) {
  if (request.request_id().size() > kLongestRequestId) {
    return absl::InvalidArgumentError(absl::StrCat("request_id: has ", request.request_id().size(),
                                                   " characters; at most ", kLongestRequestId));
  }
  CELT_ASSIGN_OR_RETURN(const v1::JobSpec spec, plans::ResolveSpec(request.spec()));
  CELT_RETURN_IF_ERROR(plans::CheckLimits(spec, limits_));
  return ToAnswer(scheduler_.Submit({.specification = plans::Serialize(spec),
                                     .owner = {},
                                     .request_id = request.request_id(),
                                     .fresh = request.fresh()}));
}

absl::StatusOr<v1::ListJobsResponse> CeltService::List(const v1::ListJobsRequest& request) const {
  CELT_ASSIGN_OR_RETURN(const jobs::JobFilter filter, ToFilter(request));
  const int size = request.page_size() == 0 ? kDefaultPage : request.page_size();
  CELT_RETURN_IF_ERROR(plans::CheckRange("page_size", size, 1, kLargestPage));
  CELT_ASSIGN_OR_RETURN(jobs::JobPage page, store_.List(filter, size, request.page_token()));
  v1::ListJobsResponse response;
  for (const jobs::Job& job : page.jobs) {
    CELT_ASSIGN_OR_RETURN(*response.add_jobs(), ToMessage(job));
  }
  response.set_next_page_token(std::move(page.next_page_token));
  return response;
}

grpc::ServerUnaryReactor* CeltService::SubmitJob(grpc::CallbackServerContext* context,
                                                 const v1::SubmitJobRequest* request,
                                                 v1::Job* response) {
  return Answer(context, Submit(*request), response);
}

grpc::ServerUnaryReactor* CeltService::GetJob(grpc::CallbackServerContext* context,
                                              const v1::GetJobRequest* request, v1::Job* response) {
  return Answer(context, ToAnswer(store_.Get(request->id())), response);
}

grpc::ServerUnaryReactor* CeltService::ListJobs(grpc::CallbackServerContext* context,
                                                const v1::ListJobsRequest* request,
                                                v1::ListJobsResponse* response) {
  return Answer(context, List(*request), response);
}

grpc::ServerUnaryReactor* CeltService::CancelJob(grpc::CallbackServerContext* context,
                                                 const v1::CancelJobRequest* request,
                                                 v1::Job* response) {
  return Answer(context, ToAnswer(scheduler_.Cancel(request->id())), response);
}

grpc::ServerUnaryReactor* CeltService::DeleteJob(grpc::CallbackServerContext* context,
                                                 const v1::DeleteJobRequest* request,
                                                 v1::DeleteJobResponse* /*response*/) {
  return Answer(context, scheduler_.Delete(request->id()));
}

grpc::ServerWriteReactor<v1::Job>* CeltService::WatchJob(grpc::CallbackServerContext* /*context*/,
                                                         const v1::WatchJobRequest* request) {
  scheduler_.Wake(request->id()).IgnoreError();  // what is wrong with the job, its stream says
  const auto stream = std::make_shared<WatchStream>(store_, request->id());
  return stream->Begin(streams_, scheduler_.notifier(), request->id());
}

grpc::ServerWriteReactor<v1::StreamResultsResponse>* CeltService::StreamResults(
    grpc::CallbackServerContext* /*context*/, const v1::StreamResultsRequest* request) {
  scheduler_.Wake(request->id()).IgnoreError();
  const auto stream = std::make_shared<ResultStream>(store_, *request);
  return stream->Begin(streams_, scheduler_.notifier(), request->id());
}

grpc::ServerUnaryReactor* CeltService::GetInfo(grpc::CallbackServerContext* context,
                                               const v1::GetInfoRequest* /*request*/,
                                               v1::GetInfoResponse* response) {
  *response = MakeInfo(scheduler_.workers());
  return Answer(context, absl::OkStatus());
}

}  // namespace celt::api
