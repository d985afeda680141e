#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "grpcpp/alarm.h"
#include "grpcpp/support/server_callback.h"
#include "server/api/open_streams.h"
#include "server/api/status.h"
#include "server/jobs/notifier.h"

namespace celt::api {

/// What a stream does next.
template <class Message>
struct Next {
  enum class Action { kWrite, kWait, kFinish };
  static Next Write(Message message) { return {Action::kWrite, std::move(message), {}, {}}; }
  static Next Finish(absl::Status status) { return {Action::kFinish, {}, std::move(status), {}}; }
  /// Until the job changes, or until that much time has passed.
  static Next Wait(absl::Duration at_most = absl::InfiniteDuration()) {
    return {Action::kWait, {}, {}, at_most};
  }

  Action action = Action::kWait;
  Message message;
  absl::Status status;
  absl::Duration at_most;
};

/// A stream about a job. One write is under way at a time, and what comes after it is looked up
/// only when it is done: a client that does not read costs one message and no thread. It lives
/// until gRPC is done with it.
template <class Message>
class JobStream : public grpc::ServerWriteReactor<Message>,
                  public Endable,
                  public std::enable_shared_from_this<JobStream<Message>> {
 public:
  /// Makes the stream go; gRPC gets what is returned. `streams` and `notifier` must outlive it.
  grpc::ServerWriteReactor<Message>* Begin(OpenStreams& streams, jobs::Notifier& notifier,
                                           const std::string& job) {
    self_ = this->shared_from_this();
    streams_ = &streams;
    const std::weak_ptr<JobStream> weak = self_;
    subscription_ = notifier.Subscribe(job, [weak] {
      if (const auto stream = weak.lock()) stream->Proceed();
    });
    streams.Add(self_);
    Proceed();
    return this;
  }

  /// Called once, when the stream ends from this side. To be set before anything else.
  void set_on_finish(std::function<void(const absl::Status&)> on_finish) {
    on_finish_ = std::move(on_finish);
  }

  void End(const absl::Status& why) override {
    {
      const std::lock_guard lock(mutex_);
      if (!end_) end_ = why;
    }
    Proceed();
  }

 protected:
  /// Asked by one thread at a time, never during a write.
  virtual Next<Message> Look() = 0;

 private:
  void OnWriteDone(bool ok) override {
    {
      const std::lock_guard lock(mutex_);
      busy_ = false;
    }
    if (ok) return Proceed();
    End(absl::CancelledError("the client is gone"));
  }

  void OnCancel() override { End(absl::CancelledError("the client has cancelled the call")); }

  void OnDone() override {
    streams_->Remove(self_);
    const auto last = std::exchange(self_, nullptr);
  }

  /// Does what can be done now. Calls gRPC with no lock held: it may call back at once.
  void Proceed() {
    const auto alive = this->shared_from_this();
    if (!BecomeBusy()) return;
    do {
      Next<Message> next = NextOrEnd();
      if (next.action == Next<Message>::Action::kWrite) return Write(std::move(next.message));
      if (next.action == Next<Message>::Action::kFinish) return Finish(next.status);
      SetAlarm(next.at_most);
    } while (WokenMeanwhile());
  }

  /// False: somebody else is at it, who will look again.
  bool BecomeBusy() {
    const std::lock_guard lock(mutex_);
    woken_ = true;
    if (busy_ || finished_) return false;
    woken_ = false;
    busy_ = true;
    return true;
  }

  bool WokenMeanwhile() {
    const std::lock_guard lock(mutex_);
    busy_ = std::exchange(woken_, false);
    return busy_;
  }

  Next<Message> NextOrEnd() {
    {
      const std::lock_guard lock(mutex_);
      if (end_) return Next<Message>::Finish(*end_);
    }
    return Look();
  }

  void Write(Message message) {
    {
      // Hands all that Look has touched to the thread that OnWriteDone will be on, also in the eyes
      // of the thread sanitizer, which does not see how gRPC does.
      const std::lock_guard lock(mutex_);
      message_ = std::move(message);
    }
    this->StartWrite(&message_);
  }

  void Finish(const absl::Status& status) {
    {
      const std::lock_guard lock(mutex_);
      finished_ = true;
    }
    subscription_.End();
    alarm_.reset();
    if (on_finish_) on_finish_(status);
    grpc::ServerWriteReactor<Message>::Finish(ToGrpc(status));
  }

  void SetAlarm(absl::Duration after) {
    if (after == absl::InfiniteDuration() || alarm_set_) return;
    alarm_set_ = true;
    // A new one each time: the one before may still be in its callback.
    alarm_ = std::make_unique<grpc::Alarm>();
    alarm_->Set(absl::ToChronoTime(absl::Now() + after),
                [stream = this->shared_from_this()](bool) { stream->OnAlarm(); });
  }

  void OnAlarm() {
    alarm_set_ = false;
    Proceed();
  }

  std::function<void(const absl::Status&)> on_finish_;
  std::shared_ptr<JobStream> self_;  // gRPC's hold on this
  OpenStreams* streams_ = nullptr;
  jobs::Notifier::Subscription subscription_;
  Message message_;                     // being written
  std::unique_ptr<grpc::Alarm> alarm_;  // used while busy
  std::atomic<bool> alarm_set_ = false;

  std::mutex mutex_;
  bool busy_ = false;      // a thread is in Proceed, or a write is under way
  bool woken_ = false;     // while busy
  bool finished_ = false;  // Finish was called
  std::optional<absl::Status> end_;
};

}  // namespace celt::api
