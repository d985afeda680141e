#pragma once

#include <filesystem>
#include <stop_token>
#include <string>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "client/cli/analysis.h"
#include "client/cli/terminal.h"
#include "client/client.h"

namespace celt::cli {

/// A folder of figures in the making: data from jobs, and scripts that plot them.
class FigureData {
 public:
  /// `client` and `terminal` must outlive this; `interrupt` is asked to stop at Ctrl-C.
  FigureData(const client::Client& client, Terminal& terminal, std::stop_token interrupt,
             std::filesystem::path folder);

  /// Makes the folder. FAILED_PRECONDITION: it can't be.
  absl::Status Open() const;
  /// Runs the job, showing what it is for, and gives its result. CANCELLED at an interrupt.
  absl::StatusOr<v1::Result> Run(const std::string& title, const v1::JobSpec& spec,
                                 absl::FunctionRef<void(const v1::Record&)> on_record) const;
  /// The same, with the records in NAME.csv.
  absl::StatusOr<v1::Result> Records(const std::string& name, const v1::JobSpec& spec) const;
  absl::Status Write(const std::string& file, const std::string& text) const;
  /// Writes NAME.gp and lets gnuplot make NAME.png of it. FAILED_PRECONDITION: it does not, and
  /// why.
  absl::Status Plot(const std::string& name, const std::string& script) const;

 private:
  const Analysis& AnalysisOf(const v1::JobSpec& spec) const;

  const client::Client& client_;
  Terminal& terminal_;
  const std::stop_token interrupt_;
  const std::filesystem::path folder_;
  const Analyses analyses_;
};

}  // namespace celt::cli
