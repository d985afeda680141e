#pragma once

#include "absl/status/status.h"
#include "celt/v1/celt.grpc.pb.h"
#include "server/api/open_streams.h"
#include "server/jobs/scheduler.h"
#include "server/jobs/store.h"
#include "server/plans/limits.h"

namespace celt::api {

/// The service celt.v1.Celt on a job store and a scheduler: parses, delegates, converts. Never
/// blocks a thread of gRPC for longer than the store takes to answer.
class CeltService final : public v1::Celt::CallbackService {
 public:
  /// Both must outlive this, and this the server that it is registered with.
  CeltService(const jobs::JobStore& store, jobs::Scheduler& scheduler,
              const plans::SpecLimits& limits)
      : store_(store), scheduler_(scheduler), limits_(limits) {}

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
  absl::StatusOr<v1::Job> Submit(const v1::SubmitJobRequest& request);
  absl::StatusOr<v1::ListJobsResponse> List(const v1::ListJobsRequest& request) const;

  const jobs::JobStore& store_;
  jobs::Scheduler& scheduler_;
  const plans::SpecLimits limits_;
  OpenStreams streams_;
};

}  // namespace celt::api
