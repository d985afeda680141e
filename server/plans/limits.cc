#include "server/plans/limits.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "absl/strings/str_cat.h"
#include "google/protobuf/descriptor.h"
#include "google/protobuf/message.h"
#include "server/jobs/status_macros.h"

namespace celt::plans {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

/// The analysis that was picked, and its field's name: analyses have one in every message that has
/// them.
struct Chosen {
  std::string name;
  const Message* analysis = nullptr;
};

Chosen AnalysisOf(const Message& message) {
  const auto* reflection = message.GetReflection();
  const FieldDescriptor* const field = reflection->GetOneofFieldDescriptor(
      message, message.GetDescriptor()->FindOneofByName("analysis"));
  if (field == nullptr) return {};
  return {field->name(), &reflection->GetMessage(message, field)};
}

/// A count of an analysis, by its field's name; 0 for one that it doesn't have.
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
  return Count(analysis, "iterates") + orbits * Count(analysis, "transient");
}

absl::Status Check(const std::string& field, const char* what, double value, std::int64_t limit) {
  if (value <= static_cast<double>(limit)) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat(field, ": ", value, " ", what, " are more than this server's ", limit));
}

absl::Status CheckSweep(const v1::SweepSpec& sweep, const SpecLimits& limits) {
  double nodes = 1;
  for (const v1::Axis& axis : sweep.axes()) nodes *= axis.nodes();
  CELT_RETURN_IF_ERROR(Check("sweep.axes", "nodes", nodes, limits.nodes));
  CELT_RETURN_IF_ERROR(Check("sweep.axes", "records", nodes, limits.records));
  const Chosen node = AnalysisOf(sweep);
  if (node.analysis == nullptr) return absl::OkStatus();
  return Check(absl::StrCat("sweep.", node.name, ".iterates"), "iterates at all nodes",
               nodes * Iterates(*node.analysis), limits.iterates);
}

}  // namespace

absl::Status CheckLimits(const v1::JobSpec& resolved, const SpecLimits& limits) {
  if (resolved.has_sweep()) return CheckSweep(resolved.sweep(), limits);
  const Chosen chosen = AnalysisOf(resolved);
  if (chosen.analysis == nullptr) return absl::OkStatus();
  const auto field = [&](const char* name) { return absl::StrCat(chosen.name, ".", name); };
  CELT_RETURN_IF_ERROR(
      Check(field("iterates"), "iterates", Iterates(*chosen.analysis), limits.iterates));
  if (resolved.has_section()) {
    const auto records = static_cast<double>(resolved.section().iterates());
    CELT_RETURN_IF_ERROR(Check("section.iterates", "records", records, limits.records));
  }
  if (resolved.has_orbit()) {
    const double records = resolved.orbit().time() / resolved.orbit().step();
    CELT_RETURN_IF_ERROR(Check("orbit.step", "records", records, limits.records));
  }
  return Check(field("most_points"), "points", Count(*chosen.analysis, "most_points"),
               limits.records);
}

}  // namespace celt::plans
