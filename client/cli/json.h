#pragma once

#include <string>

#include "celt/v1/job.pb.h"
#include "google/protobuf/message.h"

namespace celt::cli {

/// Protobuf's standard JSON mapping, on one line; the same message always gives the same text.
std::string ToJson(const google::protobuf::Message& message);

/// {"name": message}.
std::string ToJson(const std::string& name, const google::protobuf::Message& message);

/// The name of the member that is set in the only oneof of `message` ("" when none is): the
/// analysis of a JobSpec, a Record or a Result.
std::string AnalysisField(const google::protobuf::Message& message);

/// {"result": ...} with what is in the oneof of the result.
std::string ResultJson(const v1::Result& result);

}  // namespace celt::cli
