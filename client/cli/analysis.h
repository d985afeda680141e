#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "CLI/App.hpp"
#include "absl/status/status.h"
#include "celt/v1/job.pb.h"
#include "client/cli/exit_code.h"

namespace celt::cli {

class Session;

/// A row of a csv table: names of the columns with the cells.
using CsvRow = std::vector<std::pair<std::string, std::string>>;

/// A command that computes. A new one is a file that defines one of these and a line in
/// analyses.cc; submitting, streaming, progress, interruption and JSON are the same for all.
class Analysis {
 public:
  virtual ~Analysis() = default;

  /// Of the command, such as "fixed-point".
  virtual std::string command() const = 0;
  /// Of the fields in JobSpec, Record and Result, such as "fixed_point".
  virtual std::string field() const = 0;
  /// One line for help.
  virtual std::string description() const = 0;
  /// A command line that can be run as it stands.
  virtual std::string example() const = 0;

  /// Adds the options of this analysis alone; the object must outlive the parsing.
  virtual void AddOptions(CLI::App& app) = 0;
  /// Writes what was given into the specification, in which the system is already filled in, and
  /// picks the analysis. INVALID_ARGUMENT names the option.
  virtual absl::Status Fill(v1::JobSpec& spec) const = 0;

  /// The cells of a record, and of the result, under the same columns. A result without cells has
  /// no row: its records say it all.
  virtual CsvRow Csv(const v1::Record& record) const = 0;
  virtual CsvRow Csv(const v1::Result& result) const = 0;
  /// A record for people, as it comes, lines ended; nothing when only the result is for them.
  virtual std::string Line(const v1::Record&) const { return ""; }
  /// The cells of the result at a node of a sweep, the same columns for every result, an empty one
  /// too. Default: those of a csv table.
  virtual CsvRow NodeCsv(const v1::Result& result) const { return Csv(result); }
  /// The result in a few words: at a node of a sweep.
  virtual std::string Brief(const v1::Result&) const { return ""; }
  /// The result for people, lines ended.
  virtual std::string Table(const v1::Job& job, const v1::Result& result) const = 0;
  /// What is left to do when the result is printed: pictures, say.
  virtual ExitCode Afterwards(const Session&) const { return kDone; }
};

using Analyses = std::vector<std::unique_ptr<Analysis>>;

/// All of them, in the order of help.
Analyses MakeAnalyses();

}  // namespace celt::cli
