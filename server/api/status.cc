#include "server/api/status.h"

#include <string>

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

}  // namespace

grpc::Status ToGrpc(const absl::Status& status) {
  if (status.ok()) return grpc::Status::OK;
  // Both sides number the codes as google.rpc.Code does.
  return {static_cast<grpc::StatusCode>(status.code()), Shorten(std::string(status.message()))};
}

}  // namespace celt::api
