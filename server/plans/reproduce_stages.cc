// The rows on the stages of the attractor's life: figures 5 and 7 of the paper.

#include <string>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "server/jobs/status_macros.h"
#include "server/plans/reproduce_items.h"

namespace celt::plans {
namespace {

/// How a spectrum is measured. Regular regimes take long to settle and to show.
struct Length {
  std::int64_t iterates = 0;
  std::int64_t transient = 0;
  std::int32_t orbits = 16;
};

absl::StatusOr<v1::LyapunovResult> SpectrumAt(const Reproduction& reproduction, double energy,
                                              const v1::Point& start, const Length& length) {
  v1::JobSpec spec = reproduction.At(energy);
  v1::LyapunovSpec& lyapunov = *spec.mutable_lyapunov();
  lyapunov.set_iterates(length.iterates);
  lyapunov.set_transient(length.transient);
  lyapunov.set_orbits(length.orbits);
  if (start.has_l()) *lyapunov.mutable_start() = start;
  CELT_ASSIGN_OR_RETURN(const v1::Result answer, reproduction.Run(spec));
  return answer.lyapunov();
}

// A start without coordinates is the known one.

/// Where the orbit is after so many iterates.
absl::StatusOr<v1::Point> Settle(const Reproduction& reproduction, double energy,
                                 const v1::Point& start, std::int64_t iterates) {
  v1::JobSpec spec = reproduction.At(energy);
  spec.mutable_section()->set_iterates(1);
  spec.mutable_section()->set_transient(iterates);
  if (start.has_l()) *spec.mutable_section()->mutable_start() = start;
  CELT_ASSIGN_OR_RETURN(const v1::Result answer, reproduction.Run(spec));
  return answer.section().last();
}

std::string RegimeText(const v1::LyapunovResult& result) {
  std::string text;
  switch (result.regime()) {
    case v1::REGIME_PERIODIC:
      text = "periodic";
      break;
    case v1::REGIME_INVARIANT_CURVE:
      text = "invariant curve";
      break;
    case v1::REGIME_CHAOS:
      text = "chaos";
      break;
    case v1::REGIME_PSEUDO_HYPERBOLIC_CANDIDATE:
      text = "chaos, pseudo-hyperbolic candidate";
      break;
    default:
      text = "not told";
  }
  return absl::StrCat(
      text,
      ", Λ1 = ", Digits(result.exponents_per_iterate(0), result.standard_error_per_iterate(0)));
}

bool IsRegular(const v1::LyapunovResult& result) {
  return result.regime() == v1::REGIME_PERIODIC || result.regime() == v1::REGIME_INVARIANT_CURVE;
}

bool IsChaotic(const v1::LyapunovResult& result) {
  return result.regime() == v1::REGIME_CHAOS ||
         result.regime() == v1::REGIME_PSEUDO_HYPERBOLIC_CANDIDATE;
}

/// A cycle that attracts: found from where an orbit settles.
absl::StatusOr<v1::ReproduceRecord> StableCycleRow(const Reproduction& reproduction, double energy,
                                                   int period, const char* name) {
  constexpr std::int64_t kSettle = 5000;
  CELT_ASSIGN_OR_RETURN(const v1::Point settled, Settle(reproduction, energy, {}, kSettle));
  v1::JobSpec spec = reproduction.At(energy);
  spec.mutable_fixed_point()->set_period(period);
  *spec.mutable_fixed_point()->mutable_near() = settled;
  CELT_ASSIGN_OR_RETURN(const v1::Result answer, reproduction.Run(spec));
  const v1::Cycle& cycle = answer.fixed_point().cycles(0);
  return MakeRow(StatementRow{
      .section = "Fig. 5",
      .quantity = absl::StrFormat("E = %g: the attractor is the stable %s", energy, name),
      .paper = "holds",
      .computed = absl::StrCat(cycle.type(), " of period ", cycle.period()),
      .holds = cycle.period() == period && absl::StartsWith(cycle.type(), "stable")});
}

}  // namespace

absl::StatusOr<ReproduceRows> BirthRows(const Reproduction& reproduction) {
  ReproduceRows rows;
  CELT_ASSIGN_OR_RETURN(rows.emplace_back(), StableCycleRow(reproduction, 747, 1, "fixed point O"));
  CELT_ASSIGN_OR_RETURN(rows.emplace_back(),
                        StableCycleRow(reproduction, 748.4, 2, "cycle P of period 2"));
  for (const double energy : {750.0, 752.0, 754.0}) {
    const Length length = {.iterates = reproduction.Pick(100'000, 20'000), .transient = 1000};
    CELT_ASSIGN_OR_RETURN(const v1::LyapunovResult result,
                          SpectrumAt(reproduction, energy, {}, length));
    rows.push_back(
        MakeRow(StatementRow{.section = energy == 750   ? "Fig. 5"
                                        : energy == 752 ? "Fig. 6"
                                                        : "Fig. 7",
                             .quantity = absl::StrFormat(
                                 "E = %g: a discrete Lorenz attractor, by its exponents", energy),
                             .paper = "holds",
                             .computed = RegimeText(result),
                             .holds = IsChaotic(result)}));
  }
  return rows;
}

absl::StatusOr<ReproduceRows> DestructionRows(const Reproduction& reproduction) {
  ReproduceRows rows;
  for (const double energy : {755.0, 765.0, 770.0, 775.0}) {
    constexpr Length kLong = {.iterates = 400'000, .transient = 10'000};
    CELT_ASSIGN_OR_RETURN(const v1::LyapunovResult result,
                          SpectrumAt(reproduction, energy, {}, kLong));
    const bool chaos = energy == 765;
    rows.push_back(MakeRow(StatementRow{
        .section = "Fig. 7",
        .quantity = absl::StrCat("E = ", energy, ": ",
                                 chaos ? "chaos, not of Lorenz type" : "a resonant regular regime"),
        .paper = chaos ? "very probably" : "holds",
        .computed = RegimeText(result),
        .holds = chaos ? IsChaotic(result) : IsRegular(result)}));
  }
  return rows;
}

namespace {

/// How many of a few orbits from the attractor at 778 are chaotic at 780, after a transient.
absl::StatusOr<int> CountChaotic(const Reproduction& reproduction, v1::Point at, int orbits,
                                 std::int64_t transient) {
  constexpr double kChaos = 0.005;  // per iterate: 0.02 where there is chaos, -0.0024 where not
  constexpr std::int64_t kApart = 97;
  int chaotic = 0;
  for (int i = 0; i < orbits; ++i) {
    CELT_ASSIGN_OR_RETURN(at, Settle(reproduction, 778, at, kApart));
    CELT_ASSIGN_OR_RETURN(
        const v1::LyapunovResult result,
        SpectrumAt(reproduction, 780, at, {.iterates = 3000, .transient = transient, .orbits = 1}));
    chaotic += result.exponents_per_iterate(0) > kChaos ? 1 : 0;
  }
  return chaotic;
}

/// The torus chaos at 780, which turns out not to last.
absl::Status AddTorusChaos(const Reproduction& reproduction, const v1::Point& at,
                           ReproduceRows& rows) {
  constexpr int kOrbits = 8;
  constexpr std::int64_t kLate = 50'000;
  CELT_ASSIGN_OR_RETURN(const int early, CountChaotic(reproduction, at, kOrbits, 0));
  std::string remark = "over 3000 iterates, each from a point of the attractor at 778";
  if (!reproduction.quick()) {
    CELT_ASSIGN_OR_RETURN(const int late, CountChaotic(reproduction, at, kOrbits, kLate));
    absl::StrAppend(&remark, "; after ", kLate, " iterates ", late,
                    " still are, the others have settled on a stable cycle");
  }
  rows.push_back(
      MakeRow(StatementRow{.section = "Fig. 7",
                           .quantity = "E = 780: torus chaos",
                           .paper = "holds",
                           .computed = absl::StrCat(early, " of ", kOrbits, " orbits are chaotic"),
                           .holds = 2 * early > kOrbits,
                           .remark = remark}));
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<ReproduceRows> BreakdownRows(const Reproduction& reproduction) {
  // From an arbitrary start, or a little off, one falls on other attractors: one orbit, carried on.
  constexpr std::int64_t kSettle = 3000;
  constexpr double kOnAttractor = 0.7;  // mean return time; 0.78 on it, 0.56 on the other
  v1::Point at;
  double last = 0;
  ReproduceRows rows;
  for (double energy = 774; energy <= 792; energy += 2) {
    CELT_ASSIGN_OR_RETURN(at, Settle(reproduction, energy, at, kSettle));
    CELT_ASSIGN_OR_RETURN(
        const v1::LyapunovResult result,
        SpectrumAt(reproduction, energy, at, {.iterates = 3000, .transient = 0, .orbits = 1}));
    if (energy == 778) CELT_RETURN_IF_ERROR(AddTorusChaos(reproduction, at, rows));
    if (result.mean_return_time() < kOnAttractor) break;
    last = energy;
  }
  rows.push_back(MakeRow(
      StatementRow{.section = "3.3, 4",
                   .quantity = "nothing remains of the attractor for E > 790",
                   .paper = "holds",
                   .computed = absl::StrFormat("followed to %g, gone at %g", last, last + 2),
                   .holds = last >= 780 && last <= 790,
                   .remark = "carried upward from 774 in steps of 2"}));
  return rows;
}

}  // namespace celt::plans
