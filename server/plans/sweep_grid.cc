#include "server/plans/sweep_grid.h"

#include <cmath>
#include <set>

#include "absl/strings/str_cat.h"
#include "google/protobuf/descriptor.h"
#include "google/protobuf/message.h"
#include "server/jobs/status_macros.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

/// Copies what is set in the oneof of one message into the field of the same name of another.
/// Analyses have one name in every message that has them.
bool CopyChoice(const Message& from, const std::string& oneof, Message& to) {
  const FieldDescriptor* const chosen = from.GetReflection()->GetOneofFieldDescriptor(
      from, from.GetDescriptor()->FindOneofByName(oneof));
  if (chosen == nullptr) return false;
  const FieldDescriptor* const place = to.GetDescriptor()->FindFieldByName(chosen->name());
  if (place == nullptr || place->message_type() != chosen->message_type()) return false;
  to.GetReflection()
      ->MutableMessage(&to, place)
      ->CopyFrom(from.GetReflection()->GetMessage(from, chosen));
  return true;
}

absl::Status CheckAxis(const System& system, const v1::Axis& axis) {
  if (!axis.has_from()) return absl::InvalidArgumentError("from: missing");
  if (!axis.has_to()) return absl::InvalidArgumentError("to: missing");
  CELT_RETURN_IF_ERROR(CheckRange("nodes", axis.nodes(), 2, kMaxNodes));
  for (const double value : {axis.from(), axis.to()}) {
    CELT_RETURN_IF_ERROR(system.Resolve({{axis.parameter(), value}}).status());
  }
  if (axis.from() == axis.to()) {
    return absl::InvalidArgumentError(absl::StrCat("to: ", axis.to(), " is where it begins"));
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status SweepGrid::Check(const System& system, const v1::SweepSpec& spec) {
  CELT_RETURN_IF_ERROR(CheckRange("axes", spec.axes_size(), 1, 2));
  double nodes = 1;
  std::set<std::string> names;
  for (int i = 0; i < spec.axes_size(); ++i) {
    const v1::Axis& axis = spec.axes(i);
    const absl::Status status = CheckAxis(system, axis);
    if (!status.ok()) {
      return absl::InvalidArgumentError(absl::StrCat("axes[", i, "].", status.message()));
    }
    if (!names.insert(axis.parameter()).second) {
      return absl::InvalidArgumentError(
          absl::StrCat("axes[", i, "].parameter: ", axis.parameter(), " is the other axis's too"));
    }
    nodes *= axis.nodes();
  }
  if (nodes <= static_cast<double>(kMaxNodes)) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat("axes: ", nodes, " nodes in all are not allowed; at most ", kMaxNodes));
}

SweepGrid::SweepGrid(const v1::JobSpec& spec)
    : base_(spec), axes_(spec.sweep().axes().begin(), spec.sweep().axes().end()) {
  columns_ = axes_[0].nodes();
  rows_ = axes_.size() > 1 ? axes_[1].nodes() : 1;
  PutAnalysis(spec.sweep(), base_);
}

std::vector<double> SweepGrid::Values(std::int64_t node) const {
  const std::int64_t places[] = {node % columns_, node / columns_};
  std::vector<double> values;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const v1::Axis& axis = axes_[i];
    const auto last = static_cast<double>(axis.nodes() - 1);
    const auto place = static_cast<double>(places[i]);
    // The end comes out exactly.
    values.push_back(place == last ? axis.to()
                                   : axis.from() + (axis.to() - axis.from()) * place / last);
  }
  return values;
}

v1::JobSpec SweepGrid::NodeSpec(std::int64_t node) const {
  v1::JobSpec spec = base_;
  const std::vector<double> values = Values(node);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    (*spec.mutable_system()->mutable_parameters())[axes_[i].parameter()] = values[i];
  }
  return spec;
}

void PutAnalysis(const v1::SweepSpec& from, v1::JobSpec& to) { CopyChoice(from, "analysis", to); }

void PutAnalysis(const v1::JobSpec& from, v1::SweepSpec& to) { CopyChoice(from, "analysis", to); }

bool PutOutcome(const v1::Result& result, v1::SweepRecord& record) {
  return CopyChoice(result, "result", record);
}

}  // namespace celt::plans
