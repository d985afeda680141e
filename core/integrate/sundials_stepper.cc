#include "core/integrate/sundials_stepper.h"

#include <algorithm>
#include <cstdlib>

#include "absl/strings/str_cat.h"

namespace celt {
namespace {

std::span<double> Entries(N_Vector vector) {
  return {N_VGetArrayPointer(vector), static_cast<std::size_t>(N_VGetLength(vector))};
}

}  // namespace

SundialsStepper::SundialsStepper(const OdeProblem& problem, std::span<const double> start)
    : state_(N_VNew_Serial(problem.size(), context_)), problem_(problem) {
  std::ranges::copy(start, Entries(state_).begin());
}

SundialsStepper::~SundialsStepper() { N_VDestroy(state_); }

std::span<const double> SundialsStepper::state() const { return Entries(state_); }

// SUNDIALS hands user data back as it got it, without const.
void* SundialsStepper::problem() const { return const_cast<OdeProblem*>(&problem_); }

int SundialsStepper::Rate(double, N_Vector y, N_Vector rate, void* problem) {
  constexpr int kTrySmallerStep = 1;
  return static_cast<const OdeProblem*>(problem)->Rate(Entries(y), Entries(rate)) ? 0
                                                                                  : kTrySmallerStep;
}

int SundialsStepper::Weights(N_Vector y, N_Vector weights, void* problem) {
  static_cast<const OdeProblem*>(problem)->Weights(Entries(y), Entries(weights));
  return 0;
}

absl::Status SundialsStepper::StepStatus(int flag, char* name) {
  absl::Status status = absl::OkStatus();
  if (flag < 0)
    status = absl::OutOfRangeError(absl::StrCat("the integrator finds no step (", name, ")"));
  std::free(name);
  return status;
}

}  // namespace celt
