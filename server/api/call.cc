#include "server/api/call.h"

#include <algorithm>

#include "absl/time/clock.h"
#include "server/jobs/scheduler.h"

namespace celt::api {
namespace {

constexpr std::size_t kLongestRequest = 64;
constexpr const char* kRequestHeader = "x-request-id";

std::string_view Header(const grpc::CallbackServerContext& context, const char* name) {
  const auto found = context.client_metadata().find(name);
  if (found == context.client_metadata().end()) return {};
  return {found->second.data(), found->second.size()};
}

std::string RequestOf(const grpc::CallbackServerContext& context) {
  const std::string_view given = Header(context, kRequestHeader);
  const bool good =
      !given.empty() && given.size() <= kLongestRequest &&
      std::all_of(given.begin(), given.end(), [](char c) { return c > ' ' && c < 127; });
  return good ? std::string(given) : jobs::RandomJobId();
}

absl::StatusOr<auth::Identity> Identify(const grpc::CallbackServerContext& context,
                                        const auth::Gate& gate) {
  std::string name;
  const auto peer = context.auth_context();
  if (peer != nullptr && peer->IsPeerAuthenticated()) {
    const auto names = peer->FindPropertyValues("x509_common_name");
    if (!names.empty()) name.assign(names.front().data(), names.front().size());
  }
  return gate.Identify({.authorization = Header(context, "authorization"), .common_name = name});
}

}  // namespace

Call::Call(grpc::CallbackServerContext& context, std::string_view method, const auth::Gate& gate)
    : method_(method),
      began_(absl::Now()),
      request_(RequestOf(context)),
      identity_(Identify(context, gate)) {
  context.AddInitialMetadata(kRequestHeader, request_);
}

void Call::Tell(const OnCall& on_call, const absl::Status& status) const {
  on_call({.method = method_,
           .request = request_,
           .owner = identity_.ok() ? identity_->owner : "",
           .job = job_,
           .status = status,
           .took = absl::Now() - began_});
}

}  // namespace celt::api
