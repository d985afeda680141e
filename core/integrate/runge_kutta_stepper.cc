#include <algorithm>
#include <cassert>
#include <memory>

#include "arkode/arkode_erkstep.h"
#include "core/integrate/sundials_stepper.h"

namespace celt {
namespace {

/// Fehlberg's pair with a fourteenth stage at the step's end, whose rate opens the next step.
///
/// ARKODE 5.4 takes a table whose last node is 1 for one whose last stage is the step's result, and
/// opens the next step with that stage's rate. In Fehlberg's table stage 13 has node 1 and is not
/// the result: as delivered, the pair converges with order 7 at best, and needs three times the
/// steps at 1e-11. With the result as a stage of its own, what ARKODE takes for granted is true, at
/// the price of no evaluation.
ARKodeButcherTable MakeTable() {
  const ARKodeButcherTable pair = ARKodeButcherTable_LoadERK(ARKODE_FEHLBERG_13_7_8);
  const ARKodeButcherTable table = ARKodeButcherTable_Alloc(pair->stages + 1, /*embedded=*/SUNTRUE);
  table->q = pair->q;
  table->p = pair->p;
  for (int i = 0; i < pair->stages; ++i) {
    std::copy_n(pair->A[i], pair->stages, table->A[i]);
  }
  std::copy_n(pair->c, pair->stages, table->c);
  std::copy_n(pair->b, pair->stages, table->b);
  std::copy_n(pair->d, pair->stages, table->d);
  table->c[pair->stages] = 1;
  std::copy_n(pair->b, pair->stages, table->A[pair->stages]);
  ARKodeButcherTable_Free(pair);
  return table;
}

/// Made once, only read from then on; lives as long as the program.
ARKodeButcherTable Table() {
  static const ARKodeButcherTable table = MakeTable();
  return table;
}

class RungeKuttaStepper final : public SundialsStepper {
 public:
  RungeKuttaStepper(const OdeProblem& problem, std::span<const double> start, double first_step)
      : SundialsStepper(problem, start), memory_(ERKStepCreate(&Rate, /*t0=*/0, state_, context_)) {
    int failures = 0;
    failures += ERKStepSetErrHandlerFn(memory_, &Silent, nullptr) != ARK_SUCCESS;
    failures += ERKStepSetUserData(memory_, this->problem()) != ARK_SUCCESS;
    failures += ERKStepWFtolerances(memory_, &Weights) != ARK_SUCCESS;
    failures += ERKStepSetTable(memory_, Table()) != ARK_SUCCESS;
    failures += ERKStepSetInitStep(memory_, first_step) != ARK_SUCCESS;
    assert(failures == 0);
    static_cast<void>(failures);
  }

  ~RungeKuttaStepper() override { ERKStepFree(&memory_); }
  RungeKuttaStepper(const RungeKuttaStepper&) = delete;
  RungeKuttaStepper& operator=(const RungeKuttaStepper&) = delete;

  absl::Status Step(double stop) override {
    ERKStepSetStopTime(memory_, stop);
    const int flag = ERKStepEvolve(memory_, stop, state_, &time_, ARK_ONE_STEP);
    return StepStatus(flag, ERKStepGetReturnFlagName(flag));
  }

 private:
  void* memory_;
};

}  // namespace

std::unique_ptr<OdeStepper> MakeRungeKuttaStepper(const OdeProblem& problem,
                                                  std::span<const double> start,
                                                  double first_step) {
  return std::make_unique<RungeKuttaStepper>(problem, start, first_step);
}

}  // namespace celt
