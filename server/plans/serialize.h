#pragma once

#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "google/protobuf/message_lite.h"

namespace celt::plans {

/// The same bytes for the same message, maps included, from the same program.
std::string Serialize(const google::protobuf::MessageLite& message);

/// What Serialize wrote. DATA_LOSS: the bytes are not that.
template <class Message>
absl::StatusOr<Message> Parse(std::string_view bytes) {
  Message message;
  if (message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return message;
  return absl::DataLossError("the stored state of the job is damaged");
}

}  // namespace celt::plans
