#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "grpcpp/server_context.h"
#include "server/auth/gate.h"

namespace celt::api {

/// A call that has ended.
struct CallDone {
  std::string_view method;
  std::string request;  ///< its id: the caller's "x-request-id", or one made here
  std::string owner;
  std::string job;
  absl::Status status;
  absl::Duration took;
};
using OnCall = std::function<void(const CallDone&)>;

/// A call under way: who makes it, and what is told of it when it ends. Copyable.
class Call {
 public:
  /// Identifies the caller and answers with the id of the request in the header "x-request-id".
  Call(grpc::CallbackServerContext& context, std::string_view method, const auth::Gate& gate);

  /// Who calls. UNAUTHENTICATED.
  const absl::StatusOr<auth::Identity>& identity() const { return identity_; }
  void set_job(const std::string& job) { job_ = job; }
  void Tell(const OnCall& on_call, const absl::Status& status) const;

 private:
  std::string_view method_;
  absl::Time began_;
  std::string request_;
  absl::StatusOr<auth::Identity> identity_;
  std::string job_;
};

}  // namespace celt::api
