#include <cassert>
#include <memory>

#include "core/integrate/sundials_stepper.h"
#include "cvode/cvode.h"
#include "sunnonlinsol/sunnonlinsol_fixedpoint.h"

namespace celt {
namespace {

class AdamsStepper final : public SundialsStepper {
 public:
  AdamsStepper(const OdeProblem& problem, std::span<const double> start)
      : SundialsStepper(problem, start),
        memory_(CVodeCreate(CV_ADAMS, context_)),
        corrector_(SUNNonlinSol_FixedPoint(state_, /*m=*/0, context_)) {
    int failures = 0;
    failures += CVodeSetErrHandlerFn(memory_, &Silent, nullptr) != CV_SUCCESS;
    failures += CVodeInit(memory_, &Rate, /*t0=*/0, state_) != CV_SUCCESS;
    failures += CVodeSetUserData(memory_, this->problem()) != CV_SUCCESS;
    failures += CVodeWFtolerances(memory_, &Weights) != CV_SUCCESS;
    failures += CVodeSetNonlinearSolver(memory_, corrector_) != CV_SUCCESS;
    assert(failures == 0);
    static_cast<void>(failures);
  }

  ~AdamsStepper() override {
    CVodeFree(&memory_);
    SUNNonlinSolFree(corrector_);
  }
  AdamsStepper(const AdamsStepper&) = delete;
  AdamsStepper& operator=(const AdamsStepper&) = delete;

  absl::Status Step(double stop) override {
    CVodeSetStopTime(memory_, stop);
    const int flag = CVode(memory_, stop, state_, &time_, CV_ONE_STEP);
    return StepStatus(flag, CVodeGetReturnFlagName(flag));
  }

 private:
  void* memory_;
  SUNNonlinearSolver corrector_;
};

}  // namespace

std::unique_ptr<OdeStepper> MakeAdamsStepper(const OdeProblem& problem,
                                             std::span<const double> start) {
  return std::make_unique<AdamsStepper>(problem, start);
}

}  // namespace celt
