#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "celt/v1/celt.grpc.pb.h"
#include "grpcpp/grpcpp.h"

namespace celt {

/// A service whose answers a test writes down beforehand. It knows one job, "job-1".
class FakeService final : public v1::Celt::Service {
 public:
  /// What one call of StreamResults does: messages, then a status.
  struct Script {
    std::vector<v1::StreamResultsResponse> messages;
    grpc::Status end;
    /// Before the status, the stream waits until the job is cancelled or the client is gone.
    bool until_cancelled = false;
  };

  FakeService();
  ~FakeService() override;

  /// "127.0.0.1:PORT".
  const std::string& address() const { return address_; }
  std::shared_ptr<grpc::Channel> InProcessChannel();

  /// The specification last submitted.
  v1::JobSpec submitted() const;
  bool fresh() const;
  bool validate_only() const;
  /// The header "authorization" of the last submission.
  std::string authorization() const;
  bool cancelled() const;
  /// after_sequence of each StreamResults, in order.
  std::vector<std::int64_t> resumed_after() const;

  /// To be set before the first call.
  grpc::Status submit_status;
  grpc::Status cancel_status;
  std::vector<Script> scripts;  ///< of the successive streams; the last one repeats
  std::vector<v1::Job> watched;
  v1::Job job;
  /// Called when a script with until_cancelled has sent its messages.
  std::function<void()> on_waiting = [] {};

 private:
  grpc::Status SubmitJob(grpc::ServerContext*, const v1::SubmitJobRequest* request,
                         v1::Job* response) override;
  grpc::Status GetJob(grpc::ServerContext*, const v1::GetJobRequest* request,
                      v1::Job* response) override;
  grpc::Status ListJobs(grpc::ServerContext*, const v1::ListJobsRequest* request,
                        v1::ListJobsResponse* response) override;
  grpc::Status CancelJob(grpc::ServerContext*, const v1::CancelJobRequest* request,
                         v1::Job* response) override;
  grpc::Status DeleteJob(grpc::ServerContext*, const v1::DeleteJobRequest* request,
                         v1::DeleteJobResponse* response) override;
  grpc::Status WatchJob(grpc::ServerContext*, const v1::WatchJobRequest* request,
                        grpc::ServerWriter<v1::Job>* writer) override;
  grpc::Status StreamResults(grpc::ServerContext* context, const v1::StreamResultsRequest* request,
                             grpc::ServerWriter<v1::StreamResultsResponse>* writer) override;
  grpc::Status GetInfo(grpc::ServerContext*, const v1::GetInfoRequest*,
                       v1::GetInfoResponse* response) override;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  v1::JobSpec submitted_;
  bool fresh_ = false;
  bool validate_only_ = false;
  std::string authorization_;
  bool cancelled_ = false;
  std::vector<std::int64_t> resumed_after_;
  std::string address_;
  std::unique_ptr<grpc::Server> server_;
};

/// A record of the spectrum, as a message of the stream.
v1::StreamResultsResponse RecordMessage(std::int64_t sequence);
/// A spectrum, as a message of the stream.
v1::StreamResultsResponse ResultMessage();

}  // namespace celt
