#include "server/api/status.h"

#include <string>

#include "absl/strings/cord.h"
#include "absl/strings/numbers.h"
#include "absl/types/optional.h"
#include "server/api/error_details.pb.h"
#include "server/jobs/status_details.h"

namespace celt::api {
namespace {

/// Headers of 8 KiB make a client give up the call, and each byte may take three there.
constexpr std::size_t kLongest = 1000;

/// Cuts between two characters of UTF-8.
std::string Shorten(std::string text) {
  if (text.size() <= kLongest) return text;
  std::size_t end = kLongest;
  constexpr unsigned kTopBits = 0xC0;
  constexpr unsigned kContinuation = 0x80;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & kTopBits) == kContinuation) --end;
  return text.substr(0, end) + "...";
}

/// The name that a message about a field begins with; empty when it begins with none.
std::string FieldOf(const std::string& message) {
  const std::size_t end = message.find_first_not_of(
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.[]");
  // "l, l_over_g: …" is about several; the first stands for them.
  const bool list = end != std::string::npos && message[end] == ',';
  if (end == std::string::npos || end == 0 || (message[end] != ':' && !list)) return "";
  return message.substr(0, end);
}

std::string Payload(const absl::Status& status, const char* name) {
  const absl::optional<absl::Cord> payload = status.GetPayload(name);
  return payload ? std::string(*payload) : "";
}

/// What the message says, for programs: as AIP-193 wants it.
std::string Details(const absl::Status& status, const std::string& message) {
  google::rpc::Status details;
  details.set_code(status.raw_code());
  details.set_message(message);
  if (const std::string field = FieldOf(message);
      absl::IsInvalidArgument(status) && !field.empty()) {
    google::rpc::BadRequest request;
    request.add_field_violations()->set_field(field);
    details.add_details()->PackFrom(request);
  }
  if (const std::string job = Payload(status, jobs::kExistingJobPayload); !job.empty()) {
    google::rpc::ResourceInfo resource;
    resource.set_resource_type("celt.v1.Job");
    resource.set_resource_name(job);
    details.add_details()->PackFrom(resource);
  }
  if (int seconds = 0; absl::SimpleAtoi(Payload(status, jobs::kRetrySecondsPayload), &seconds)) {
    google::rpc::RetryInfo retry;
    retry.mutable_retry_delay()->set_seconds(seconds);
    details.add_details()->PackFrom(retry);
  }
  return details.details().empty() ? "" : details.SerializeAsString();
}

}  // namespace

grpc::Status ToGrpc(const absl::Status& status) {
  if (status.ok()) return grpc::Status::OK;
  // Both sides number the codes as google.rpc.Code does.
  const auto code = static_cast<grpc::StatusCode>(status.code());
  const std::string message = Shorten(std::string(status.message()));
  return {code, message, Details(status, message)};
}

}  // namespace celt::api
