#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "server/jobs/plan.h"

namespace celt::plans {

/// What the items of the paper's table are made with: jobs on the paper's stone, and rows.
class Reproduction {
 public:
  /// `base` is a resolved specification: its system, engine and frame are those of all the jobs.
  Reproduction(const v1::JobSpec& base, bool quick, const jobs::StopRequested& stop)
      : base_(base), quick_(quick), stop_(stop) {}

  bool quick() const { return quick_; }
  /// One number for a run of minutes, another for one that is to be over in a minute.
  std::int64_t Pick(std::int64_t whole, std::int64_t quick) const { return quick_ ? quick : whole; }

  /// A specification on the paper's stone at this energy, without an analysis yet.
  v1::JobSpec At(double energy) const;
  /// Resolves it, runs it here, and gives its result. Status: as that job's.
  absl::StatusOr<v1::Result> Run(const v1::JobSpec& spec) const;

 private:
  const v1::JobSpec& base_;
  bool quick_;
  const jobs::StopRequested& stop_;
};

/// A number that the paper prints beside the computed one. It agrees when they differ by no more
/// than `printed_error` (what the printed digits leave open) and three errors.
struct NumberRow {
  std::string section;
  std::string quantity;
  std::string paper;  ///< as printed
  double printed = 0;
  double printed_error = 0;
  double computed = 0;
  double error = 0;
  std::string remark = {};
};
v1::ReproduceRecord MakeRow(const NumberRow& row);

/// A statement of the paper, and whether it holds.
struct StatementRow {
  std::string section;
  std::string quantity;
  std::string paper;
  std::string computed;
  bool holds = false;
  std::string remark = {};
};
v1::ReproduceRecord MakeRow(const StatementRow& row);

/// The number to the digits that its error leaves certain, two of the error's: "0.02531".
std::string Digits(double value, double error);

}  // namespace celt::plans
