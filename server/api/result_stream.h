#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "celt/v1/celt.pb.h"
#include "server/api/job_stream.h"
#include "server/jobs/store.h"

namespace celt::api {

/// The stream of StreamResults: records after a sequence number, then the result.
class ResultStream final : public JobStream<v1::StreamResultsResponse> {
 public:
  ResultStream(const jobs::JobStore& store, const v1::StreamResultsRequest& request)
      : store_(store), id_(request.id()), after_(request.after_sequence()) {}

 private:
  using Step = Next<v1::StreamResultsResponse>;

  Step Look() override;
  Step WriteRecord();
  Step AfterTheRecords(const jobs::Job& job);

  const jobs::JobStore& store_;
  const std::string id_;
  std::int64_t after_;  // the last record that was read from the store
  std::deque<jobs::StoredRecord> chunk_;
  bool result_written_ = false;
};

}  // namespace celt::api
