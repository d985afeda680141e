// The rows on the bifurcations that lead to the attractor: section 3.3 of the paper, item 4.

#include <algorithm>
#include <string>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "server/jobs/status_macros.h"
#include "server/plans/reproduce_items.h"

namespace celt::plans {
namespace {

constexpr char kSection[] = "3.3, 4";

const v1::Bifurcation* Find(const v1::ContinuationResult& result, v1::BifurcationType type) {
  for (const v1::Bifurcation& bifurcation : result.bifurcations()) {
    if (bifurcation.type() == type) return &bifurcation;
  }
  return nullptr;
}

double ErrorOf(const v1::Bifurcation& bifurcation) {
  // The map's own error comes on top of the bracket.
  constexpr double kFromMap = 1e-9;
  return std::max(bifurcation.value_error(), kFromMap);
}

v1::ReproduceRecord DoublingRow(const v1::Bifurcation& doubling, const v1::Bifurcation* meeting) {
  std::string remark;
  if (meeting != nullptr) {
    remark =
        absl::StrFormat("at %.7f two multipliers meet on the negative axis; one crosses -1 later",
                        meeting->value());
  }
  return MakeRow(NumberRow{.section = kSection,
                           .quantity = "E1, period doubling of O",
                           .paper = "747.61",
                           .printed = 747.61,
                           .printed_error = 0.005,
                           .computed = doubling.value(),
                           .error = ErrorOf(doubling),
                           .remark = remark});
}

void AddTorus(const v1::Bifurcation& torus, ReproduceRows& rows) {
  std::string remark = "the angle of the pair is ";
  absl::StrAppendFormat(&remark, "%.6f", torus.angle());
  rows.push_back(MakeRow(NumberRow{.section = kSection,
                                   .quantity = "E4, torus birth of the cycle P of period 2",
                                   .paper = "~748.98",
                                   .printed = 748.98,
                                   .printed_error = 0.005,
                                   .computed = torus.value(),
                                   .error = ErrorOf(torus),
                                   .remark = remark}));
  rows.push_back(MakeRow(
      StatementRow{.section = kSection,
                   .quantity = "the torus birth of P is subcritical",
                   .paper = "holds",
                   .computed = absl::StrCat(torus.criticality(), ", first Lyapunov coefficient ",
                                            Digits(torus.coefficient(), torus.coefficient_error())),
                   .holds = torus.criticality() == "subcritical"}));
}

/// The value at which a separatrix of O changes its fate.
absl::StatusOr<v1::SeparatrixResult> Switch(const Reproduction& reproduction,
                                            v1::SeparatrixQuestion question, double from, double to,
                                            double width) {
  v1::JobSpec spec = reproduction.At(from);
  v1::SeparatrixSpec& separatrix = *spec.mutable_separatrix();
  separatrix.set_parameter("energy");
  separatrix.set_from(from);
  separatrix.set_to(to);
  separatrix.set_width(width);
  separatrix.set_question(question);
  CELT_ASSIGN_OR_RETURN(const v1::Result answer, reproduction.Run(spec));
  return answer.separatrix();
}

}  // namespace

absl::StatusOr<ReproduceRows> BifurcationRows(const Reproduction& reproduction) {
  v1::JobSpec spec = reproduction.At(752);
  v1::ContinuationSpec& continuation = *spec.mutable_continuation();
  continuation.set_parameter("energy");
  continuation.set_from(752);
  continuation.set_to(747);
  continuation.set_doublings(1);
  CELT_ASSIGN_OR_RETURN(const v1::Result answer, reproduction.Run(spec));
  const v1::ContinuationResult& result = answer.continuation();
  ReproduceRows rows;
  const v1::Bifurcation* const doubling = Find(result, v1::PERIOD_DOUBLING);
  const v1::Bifurcation* const torus = Find(result, v1::NEIMARK_SACKER);
  if (doubling == nullptr || torus == nullptr) {
    return absl::NotFoundError("not both bifurcations were met on the branches of O and P");
  }
  rows.push_back(DoublingRow(*doubling, Find(result, v1::MULTIPLIERS_MEET)));
  AddTorus(*torus, rows);
  return rows;
}

absl::StatusOr<ReproduceRows> ButterflyRows(const Reproduction& reproduction) {
  CELT_ASSIGN_OR_RETURN(const v1::SeparatrixResult result,
                        Switch(reproduction, v1::SEPARATRIX_QUESTION_RETURNS, 748.4, 748.5, 1e-7));
  return ReproduceRows{MakeRow(NumberRow{.section = kSection,
                                         .quantity = "E2, homoclinic butterfly of O",
                                         .paper = "748.4395",
                                         .printed = 748.4395,
                                         .printed_error = 5e-5,
                                         .computed = result.value(),
                                         .error = result.error()})};
}

absl::StatusOr<ReproduceRows> BasinRows(const Reproduction& reproduction) {
  CELT_ASSIGN_OR_RETURN(const v1::SeparatrixResult result,
                        Switch(reproduction, v1::SEPARATRIX_QUESTION_TENDS, 748.9, 749, 4e-3));
  return ReproduceRows{
      MakeRow(NumberRow{.section = kSection,
                        .quantity = "E3, the separatrices of O leave the basin of P",
                        .paper = "~748.97",
                        .printed = 748.97,
                        .printed_error = 0.005,
                        .computed = result.value(),
                        .error = result.error(),
                        .remark = "for E above, points of a separatrix no longer tend to P"})};
}

}  // namespace celt::plans
