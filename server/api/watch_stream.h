#pragma once

#include <optional>
#include <string>

#include "absl/time/time.h"
#include "celt/v1/celt.pb.h"
#include "server/api/job_stream.h"
#include "server/jobs/store.h"

namespace celt::api {

/// The stream of WatchJob: the job whenever it has changed. A new state is told at once, progress
/// now and then.
class WatchStream final : public JobStream<v1::Job> {
 public:
  WatchStream(const jobs::JobStore& store, const v1::WatchJobRequest& request)
      : store_(store), id_(request.id()) {}

 private:
  using Step = Next<v1::Job>;

  Step Look() override;
  Step Tell(const jobs::Job& job);

  const jobs::JobStore& store_;
  const std::string id_;
  std::optional<jobs::Job> told_;
  absl::Time told_at_ = absl::InfinitePast();
};

}  // namespace celt::api
