#include "server/api/celt_service.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/api/info.h"
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

/// The job that an answer is about, for the log.
std::string JobOf(const v1::Job& job) { return job.id(); }
template <class Message>
std::string JobOf(const Message&) {
  return "";
}

}  // namespace

void CeltService::EndStreams() { streams_.EndAll(jobs::ShuttingDown()); }

template <class Message, class Work>
grpc::ServerUnaryReactor* CeltService::Answer(grpc::CallbackServerContext* context,
                                              std::string_view method, Message* response,
                                              Work work) {
  Call call(*context, method, gate_);
  absl::Status status = call.identity().status();
  if (status.ok()) {
    absl::StatusOr<Message> answer = work(*call.identity());
    status = answer.status();
    if (answer.ok()) *response = *std::move(answer);
  }
  call.set_job(JobOf(*response));
  call.Tell(options_.on_call, status);
  grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
  reactor->Finish(ToGrpc(status));
  return reactor;
}

template <class Stream, class Message, class Request>
grpc::ServerWriteReactor<Message>* CeltService::Begin(grpc::CallbackServerContext* context,
                                                      std::string_view method,
                                                      const Request& request) {
  Call call(*context, method, gate_);
  absl::Status status = call.identity().status();
  if (status.ok()) status = Own(*call.identity(), request.id()).status();
  // What is wrong with a job that can't be woken, its stream says.
  if (status.ok()) scheduler_.Wake(request.id()).IgnoreError();
  const auto stream = std::make_shared<Stream>(store_, request);
  call.set_job(status.ok() ? request.id() : "");
  stream->set_on_finish(
      [this, call](const absl::Status& end) { call.Tell(options_.on_call, end); });
  if (!status.ok()) stream->End(status);
  return stream->Begin(streams_, scheduler_.notifier(), request.id());
}

absl::StatusOr<jobs::Job> CeltService::Own(const auth::Identity& who, const std::string& id) const {
  absl::StatusOr<jobs::Job> job = store_.Get(id);
  if (!job.ok() || who.admin || job->owner == who.owner) return job;
  return absl::NotFoundError(absl::StrCat("id: there is no job ", id));
}

absl::StatusOr<v1::Job> CeltService::ToAnswer(const absl::StatusOr<jobs::Job>& job) const {
  if (!job.ok()) return job.status();
  CELT_ASSIGN_OR_RETURN(v1::Job message, ToMessage(*job));
  if (const auto estimate = scheduler_.forecast().Of(job->id)) {
    *message.mutable_estimate() = ToMessage(*estimate);
  }
  return message;
}

absl::StatusOr<v1::Job> CeltService::Foretell(const jobs::Submission& submission,
                                              const v1::JobSpec& spec) const {
  CELT_ASSIGN_OR_RETURN(const std::optional<jobs::Job> known, scheduler_.FindAnswer(submission));
  if (known) return ToMessage(*known);
  CELT_ASSIGN_OR_RETURN(const jobs::Estimate estimate,
                        scheduler_.Foretell(submission.specification));
  v1::Job answer;
  *answer.mutable_spec() = spec;
  *answer.mutable_estimate() = ToMessage(estimate);
  return answer;
}

absl::StatusOr<v1::Job> CeltService::Submit(const auth::Identity& who,
                                            const v1::SubmitJobRequest& request) {
  if (request.request_id().size() > kLongestRequestId) {
    return absl::InvalidArgumentError(absl::StrCat("request_id: has ", request.request_id().size(),
                                                   " characters; at most ", kLongestRequestId));
  }
  CELT_ASSIGN_OR_RETURN(const v1::JobSpec spec, plans::ResolveSpec(request.spec()));
  CELT_RETURN_IF_ERROR(plans::CheckLimits(spec, options_.limits));
  const jobs::Submission submission{.specification = plans::Serialize(spec),
                                    .owner = who.owner,
                                    .request_id = request.request_id(),
                                    .fresh = request.fresh()};
  if (request.validate_only()) return Foretell(submission, spec);
  return ToAnswer(scheduler_.Submit(submission));
}

absl::StatusOr<v1::ListJobsResponse> CeltService::List(const auth::Identity& who,
                                                       const v1::ListJobsRequest& request) const {
  CELT_ASSIGN_OR_RETURN(jobs::JobFilter filter, ToFilter(request));
  if (!who.admin) filter.owner = who.owner;
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
  return Answer(context, "SubmitJob", response,
                [&](const auth::Identity& who) { return Submit(who, *request); });
}

grpc::ServerUnaryReactor* CeltService::GetJob(grpc::CallbackServerContext* context,
                                              const v1::GetJobRequest* request, v1::Job* response) {
  return Answer(context, "GetJob", response,
                [&](const auth::Identity& who) { return ToAnswer(Own(who, request->id())); });
}

grpc::ServerUnaryReactor* CeltService::ListJobs(grpc::CallbackServerContext* context,
                                                const v1::ListJobsRequest* request,
                                                v1::ListJobsResponse* response) {
  return Answer(context, "ListJobs", response,
                [&](const auth::Identity& who) { return List(who, *request); });
}

grpc::ServerUnaryReactor* CeltService::CancelJob(grpc::CallbackServerContext* context,
                                                 const v1::CancelJobRequest* request,
                                                 v1::Job* response) {
  const auto cancel = [&](const auth::Identity& who) -> absl::StatusOr<v1::Job> {
    CELT_RETURN_IF_ERROR(Own(who, request->id()).status());
    return ToAnswer(scheduler_.Cancel(request->id()));
  };
  return Answer(context, "CancelJob", response, cancel);
}

grpc::ServerUnaryReactor* CeltService::DeleteJob(grpc::CallbackServerContext* context,
                                                 const v1::DeleteJobRequest* request,
                                                 v1::DeleteJobResponse* response) {
  const auto remove = [&](const auth::Identity& who) -> absl::StatusOr<v1::DeleteJobResponse> {
    CELT_RETURN_IF_ERROR(Own(who, request->id()).status());
    CELT_RETURN_IF_ERROR(scheduler_.Delete(request->id()));
    return v1::DeleteJobResponse();
  };
  return Answer(context, "DeleteJob", response, remove);
}

grpc::ServerWriteReactor<v1::Job>* CeltService::WatchJob(grpc::CallbackServerContext* context,
                                                         const v1::WatchJobRequest* request) {
  return Begin<WatchStream, v1::Job>(context, "WatchJob", *request);
}

grpc::ServerWriteReactor<v1::StreamResultsResponse>* CeltService::StreamResults(
    grpc::CallbackServerContext* context, const v1::StreamResultsRequest* request) {
  return Begin<ResultStream, v1::StreamResultsResponse>(context, "StreamResults", *request);
}

grpc::ServerUnaryReactor* CeltService::GetInfo(grpc::CallbackServerContext* context,
                                               const v1::GetInfoRequest* /*request*/,
                                               v1::GetInfoResponse* response) {
  return Answer(context, "GetInfo", response,
                [&](const auth::Identity&) -> absl::StatusOr<v1::GetInfoResponse> {
                  return MakeInfo(scheduler_.workers(), options_.limits, scheduler_.limits());
                });
}

}  // namespace celt::api
