#include "server/plans/chain_plan.h"

#include "server/jobs/status_macros.h"
#include "server/plans/serialize.h"
#include "server/plans/state.pb.h"

namespace celt::plans {

absl::StatusOr<jobs::UnitOutput> ChainPlan::Run(jobs::UnitId, std::string_view checkpoint,
                                                const jobs::StopRequested& stop) const {
  CELT_ASSIGN_OR_RETURN(const ChainCheckpoint before, Parse<ChainCheckpoint>(checkpoint));
  if (before.error_code() != 0) {
    return absl::Status(static_cast<absl::StatusCode>(before.error_code()), before.error_message());
  }
  CELT_ASSIGN_OR_RETURN(const Stretch stretch, Advance(before.state(), stop));
  ChainCheckpoint after;
  after.set_state(stretch.state);
  after.set_error_code(stretch.error.raw_code());
  after.set_error_message(std::string(stretch.error.message()));
  ChainPayload payload;
  for (const v1::Record& record : stretch.records) payload.add_records(Serialize(record));
  payload.set_summary(stretch.summary);
  jobs::UnitOutput output;
  output.checkpoint = Serialize(after);
  output.payload = Serialize(payload);
  output.work = stretch.work;
  // A failure is a unit of its own, so that this one's records are kept.
  output.chain_ended = stretch.ended && stretch.error.ok();
  return output;
}

absl::StatusOr<jobs::Collected> ChainPlan::Collect(jobs::UnitId, std::string_view state,
                                                   std::string_view payload) const {
  CELT_ASSIGN_OR_RETURN(const ChainPayload unit, Parse<ChainPayload>(payload));
  jobs::Collected collected;
  CELT_ASSIGN_OR_RETURN(collected.state, Fold(state, unit.summary()));
  collected.records.assign(unit.records().begin(), unit.records().end());
  return collected;
}

absl::StatusOr<std::string> ChainPlan::Finish(std::string_view state) const {
  CELT_ASSIGN_OR_RETURN(const v1::Result result, MakeResult(state));
  return Serialize(result);
}

absl::StatusOr<std::string> ChainPlan::Fold(std::string_view, std::string_view summary) const {
  return std::string(summary);
}

}  // namespace celt::plans
