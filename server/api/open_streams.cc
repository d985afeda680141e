#include "server/api/open_streams.h"

namespace celt::api {

void OpenStreams::Add(const std::shared_ptr<Endable>& stream) {
  absl::Status ended;
  {
    const std::lock_guard lock(mutex_);
    streams_.insert(stream);
    ended = ended_;
  }
  if (!ended.ok()) stream->End(ended);
}

void OpenStreams::Remove(const std::shared_ptr<Endable>& stream) {
  const std::lock_guard lock(mutex_);
  streams_.erase(stream);
}

std::int64_t OpenStreams::size() {
  const std::lock_guard lock(mutex_);
  return std::ssize(streams_);
}

void OpenStreams::EndAll(const absl::Status& why) {
  std::set<std::shared_ptr<Endable>> streams;
  {
    const std::lock_guard lock(mutex_);
    ended_ = why;
    streams = streams_;
  }
  for (const std::shared_ptr<Endable>& stream : streams) stream->End(why);
}

}  // namespace celt::api
