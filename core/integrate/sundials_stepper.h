#pragma once

#include <span>

#include "absl/status/status.h"
#include "core/integrate/ode_stepper.h"
#include "nvector/nvector_serial.h"
#include "sundials/sundials_context.hpp"

namespace celt {

/// What CVODE and ARKODE share: the context, the vector and the callbacks, which have the same
/// signature in both. Errors come back as codes only: nothing is printed.
class SundialsStepper : public OdeStepper {
 public:
  SundialsStepper(const OdeProblem& problem, std::span<const double> start);
  ~SundialsStepper() override;
  SundialsStepper(const SundialsStepper&) = delete;
  SundialsStepper& operator=(const SundialsStepper&) = delete;

  double time() const final { return time_; }
  std::span<const double> state() const final;

 protected:
  static int Rate(double time, N_Vector y, N_Vector rate, void* problem);
  static int Weights(N_Vector y, N_Vector weights, void* problem);
  static void Silent(int, const char*, const char*, char*, void*) {}
  /// The status of a step that ended with this flag; takes over the flag's name, which SUNDIALS
  /// allocates.
  static absl::Status StepStatus(int flag, char* name);

  void* problem() const;

  sundials::Context context_;
  N_Vector state_;
  double time_ = 0;

 private:
  const OdeProblem& problem_;
};

}  // namespace celt
