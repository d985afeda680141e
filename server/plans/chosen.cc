#include "server/plans/chosen.h"

#include <algorithm>

#include "google/protobuf/descriptor.h"

namespace celt::plans {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

Chosen AnalysisOf(const Message& message) {
  const auto* reflection = message.GetReflection();
  const FieldDescriptor* const field = reflection->GetOneofFieldDescriptor(
      message, message.GetDescriptor()->FindOneofByName("analysis"));
  if (field == nullptr) return {};
  return {field->name(), &reflection->GetMessage(message, field)};
}

double Count(const Message& analysis, const std::string& name) {
  const FieldDescriptor* const field = analysis.GetDescriptor()->FindFieldByName(name);
  if (field == nullptr) return 0;
  const auto* reflection = analysis.GetReflection();
  if (field->cpp_type() == FieldDescriptor::CPPTYPE_INT64) {
    return static_cast<double>(reflection->GetInt64(analysis, field));
  }
  return static_cast<double>(reflection->GetInt32(analysis, field));
}

double Iterates(const Message& analysis) {
  const double orbits = std::max(Count(analysis, "orbits"), 1.0);
  return Count(analysis, "iterates") + Count(analysis, "scout") +
         orbits * Count(analysis, "transient");
}

}  // namespace celt::plans
