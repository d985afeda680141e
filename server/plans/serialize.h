#pragma once

#include <string>

#include "google/protobuf/message_lite.h"

namespace celt::plans {

/// The same bytes for the same message, maps included, from the same program.
std::string Serialize(const google::protobuf::MessageLite& message);

}  // namespace celt::plans
