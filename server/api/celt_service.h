#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "celt/v1/celt.grpc.pb.h"
#include "server/api/call.h"
#include "server/api/open_streams.h"
#include "server/auth/gate.h"
#include "server/jobs/scheduler.h"
#include "server/jobs/store.h"
#include "server/plans/limits.h"

namespace celt::api {

struct ServiceOptions {
  plans::SpecLimits limits;
  OnCall on_call = [](const CallDone&) {};
};

/// The service celt.v1.Celt on a job store and a scheduler: parses, delegates, converts. Never
/// blocks a thread of gRPC for longer than the store takes to answer. A job of another owner is as
/// good as none.
class CeltService final : public v1::Celt::CallbackService {
 public:
  /// All must outlive this, and this the server that it is registered with.
  CeltService(const jobs::JobStore& store, jobs::Scheduler& scheduler, const auth::Gate& gate,
              ServiceOptions options)
      : store_(store), scheduler_(scheduler), gate_(gate), options_(std::move(options)) {}

  std::int64_t open_streams() { return streams_.size(); }
  /// Ends all streams, now and in future, with UNAVAILABLE: clients come back later.
  void EndStreams();

  grpc::ServerUnaryReactor* SubmitJob(grpc::CallbackServerContext* context,
                                      const v1::SubmitJobRequest* request,
                                      v1::Job* response) override;
  grpc::ServerUnaryReactor* GetJob(grpc::CallbackServerContext* context,
                                   const v1::GetJobRequest* request, v1::Job* response) override;
  grpc::ServerUnaryReactor* ListJobs(grpc::CallbackServerContext* context,
                                     const v1::ListJobsRequest* request,
                                     v1::ListJobsResponse* response) override;
  grpc::ServerUnaryReactor* CancelJob(grpc::CallbackServerContext* context,
                                      const v1::CancelJobRequest* request,
                                      v1::Job* response) override;
  grpc::ServerUnaryReactor* DeleteJob(grpc::CallbackServerContext* context,
                                      const v1::DeleteJobRequest* request,
                                      v1::DeleteJobResponse* response) override;
  grpc::ServerWriteReactor<v1::Job>* WatchJob(grpc::CallbackServerContext* context,
                                              const v1::WatchJobRequest* request) override;
  grpc::ServerWriteReactor<v1::StreamResultsResponse>* StreamResults(
      grpc::CallbackServerContext* context, const v1::StreamResultsRequest* request) override;
  grpc::ServerUnaryReactor* GetInfo(grpc::CallbackServerContext* context,
                                    const v1::GetInfoRequest* request,
                                    v1::GetInfoResponse* response) override;

 private:
  /// Answers with what `work` gives for the caller.
  template <class Message, class Work>
  grpc::ServerUnaryReactor* Answer(grpc::CallbackServerContext* context, std::string_view method,
                                   Message* response, Work work);
  /// Begins a stream about a job of the caller's.
  template <class Stream, class Message, class Request>
  grpc::ServerWriteReactor<Message>* Begin(grpc::CallbackServerContext* context,
                                           std::string_view method, const Request& request);

  /// With its estimate, as long as it has not ended.
  absl::StatusOr<v1::Job> ToAnswer(const absl::StatusOr<jobs::Job>& job) const;
  /// What a submission would come to: the job that has given the answer, or one that there is none
  /// of, with a resolved specification and its estimate.
  absl::StatusOr<v1::Job> Foretell(const jobs::Submission& submission,
                                   const v1::JobSpec& spec) const;
  absl::StatusOr<v1::Job> Submit(const auth::Identity& who, const v1::SubmitJobRequest& request);
  absl::StatusOr<v1::ListJobsResponse> List(const auth::Identity& who,
                                            const v1::ListJobsRequest& request) const;
  /// The job if the caller may know of it. NOT_FOUND otherwise.
  absl::StatusOr<jobs::Job> Own(const auth::Identity& who, const std::string& id) const;

  const jobs::JobStore& store_;
  jobs::Scheduler& scheduler_;
  const auth::Gate& gate_;
  const ServiceOptions options_;
  OpenStreams streams_;
};

}  // namespace celt::api
