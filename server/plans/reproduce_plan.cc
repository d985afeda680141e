#include "server/plans/reproduce_plan.h"

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"
#include "server/plans/reproduce_items.h"
#include "server/plans/reproduce_rows.h"
#include "server/plans/serialize.h"
#include "server/plans/state.pb.h"

namespace celt::plans {
namespace {

v1::ReproduceRecord FailedRow(const ReproduceItem& item, const absl::Status& why) {
  v1::ReproduceRecord row;
  row.set_section(item.section);
  row.set_quantity(item.quantity);
  row.set_computed("not computed");
  row.set_verdict(v1::FAILS);
  row.set_remark(std::string(why.message()));
  return row;
}

}  // namespace

std::int64_t ReproducePlan::chains() const { return std::ssize(ReproduceItems()); }

jobs::Work ReproducePlan::work() const {
  return {.total = static_cast<double>(chains()), .unit = "items"};
}

absl::StatusOr<jobs::UnitOutput> ReproducePlan::Run(jobs::UnitId unit, std::string_view,
                                                    const jobs::StopRequested& stop) const {
  const ReproduceItem& item = ReproduceItems()[unit.chain];
  auto rows = item.compute(Reproduction(spec_, spec_.reproduce().quick(), stop));
  if (absl::IsCancelled(rows.status())) return rows.status();
  if (!rows.ok()) rows = ReproduceRows{FailedRow(item, rows.status())};
  ChainPayload payload;
  for (const v1::ReproduceRecord& row : *rows) {
    v1::Record record;
    *record.mutable_reproduce() = row;
    payload.add_records(Serialize(record));
  }
  jobs::UnitOutput output;
  output.payload = Serialize(payload);
  output.work = 1;
  return output;
}

/// The state is the result so far.
absl::StatusOr<jobs::Collected> ReproducePlan::Collect(jobs::UnitId, std::string_view state,
                                                       std::string_view payload) const {
  CELT_ASSIGN_OR_RETURN(const ChainPayload unit, Parse<ChainPayload>(payload));
  CELT_ASSIGN_OR_RETURN(v1::ReproduceResult result, Parse<v1::ReproduceResult>(state));
  jobs::Collected collected;
  collected.records.assign(unit.records().begin(), unit.records().end());
  for (const std::string& bytes : collected.records) {
    CELT_ASSIGN_OR_RETURN(const v1::Record record, Parse<v1::Record>(bytes));
    const v1::ReproduceRecord& row = *(result.add_rows()) = record.reproduce();
    const bool good = row.verdict() == v1::AGREES || row.verdict() == v1::HOLDS;
    result.set_agree(result.agree() + (good ? 1 : 0));
    result.set_differ(result.differ() + (good ? 0 : 1));
  }
  collected.state = Serialize(result);
  return collected;
}

absl::StatusOr<std::string> ReproducePlan::Finish(std::string_view state) const {
  v1::Result result;
  CELT_ASSIGN_OR_RETURN(*result.mutable_reproduce(), Parse<v1::ReproduceResult>(state));
  return Serialize(result);
}

absl::Status ResolveReproduce(const System& system, v1::JobSpec& spec) {
  if (system.name() != AllSystems().front()->name()) {
    return absl::InvalidArgumentError(
        "system: only celtic-stone for reproduce, whose paper is about it");
  }
  for (const ParameterInfo& info : system.parameters()) {
    const double value = spec.system().parameters().at(std::string(info.name));
    if (value == info.default_value) continue;
    return absl::InvalidArgumentError(absl::StrCat(std::string(info.name), ": ", value,
                                                   " is not allowed for reproduce; the paper's is ",
                                                   info.default_value));
  }
  // The paper prints its points in its own frame.
  spec.set_frame(v1::FRAME_PAPER);
  return absl::OkStatus();
}

absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeReproducePlan(const v1::JobSpec& resolved) {
  return std::make_unique<ReproducePlan>(resolved);
}

}  // namespace celt::plans
