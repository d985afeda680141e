#include "client/cli/figure_data.h"

#include <spawn.h>
#include <sys/wait.h>

#include <cassert>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/csv.h"

extern char** environ;

namespace celt::cli {
namespace {

std::vector<std::string> Cells(const CsvRow& row, bool header) {
  std::vector<std::string> cells;
  for (const auto& [column, cell] : row) cells.push_back(header ? column : cell);
  return cells;
}

/// Runs gnuplot in the folder; its own messages go to standard error.
absl::Status RunGnuplot(const std::filesystem::path& folder, const std::string& script) {
  std::string program = "gnuplot";
  std::string file = script;
  char* const arguments[] = {program.data(), file.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) {
    return absl::FailedPreconditionError(absl::StrCat(
        "gnuplot: ", std::strerror(failed), "; the data and the scripts are in ", folder.string()));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return absl::OkStatus();
  return absl::FailedPreconditionError(
      absl::StrCat("gnuplot: failed on ", (folder / script).string()));
}

}  // namespace

FigureData::FigureData(const client::Client& client, Terminal& terminal, std::stop_token interrupt,
                       std::filesystem::path folder)
    : client_(client),
      terminal_(terminal),
      interrupt_(std::move(interrupt)),
      folder_(std::move(folder)),
      analyses_(MakeAnalyses()) {}

absl::Status FigureData::Open() const {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (!error) return absl::OkStatus();
  return absl::FailedPreconditionError(
      absl::StrCat("--figures: ", folder_.string(), ": ", error.message()));
}

const Analysis& FigureData::AnalysisOf(const v1::JobSpec& spec) const {
  const auto* const oneof = spec.GetDescriptor()->FindOneofByName("analysis");
  const std::string& field = spec.GetReflection()->GetOneofFieldDescriptor(spec, oneof)->name();
  for (const auto& analysis : analyses_) {
    if (analysis->field() == field) return *analysis;
  }
  assert(false);
  return *analyses_.front();
}

absl::StatusOr<v1::Result> FigureData::Run(
    const std::string& title, const v1::JobSpec& spec,
    absl::FunctionRef<void(const v1::Record&)> on_record) const {
  terminal_.Progress(absl::StrCat("  data of the figures: ", title));
  v1::SubmitJobRequest request;
  *request.mutable_spec() = spec;
  const auto job = client_.Submit(request);
  if (!job.ok()) return job.status();
  const auto pass_on = [&](const v1::Record& record) {
    on_record(record);
    return absl::OkStatus();
  };
  auto result = client_.Stream(job->id(), 0, pass_on, interrupt_);
  if (!interrupt_.stop_requested()) return result;
  constexpr absl::Duration kPatience = absl::Seconds(2);
  static_cast<void>(client_.Cancel(job->id(), kPatience));
  return absl::CancelledError("interrupted");
}

absl::StatusOr<v1::Result> FigureData::Records(const std::string& name,
                                               const v1::JobSpec& spec) const {
  const Analysis& analysis = AnalysisOf(spec);
  std::string text;
  const auto add = [&](const v1::Record& record) {
    const CsvRow row = analysis.Csv(record);
    if (text.empty()) text = CsvLine(Cells(row, true));
    absl::StrAppend(&text, CsvLine(Cells(row, false)));
  };
  auto result = Run(name, spec, add);
  if (!result.ok()) return result;
  const absl::Status written = Write(name + ".csv", text);
  return written.ok() ? result : written;
}

absl::Status FigureData::Write(const std::string& file, const std::string& text) const {
  std::ofstream out(folder_ / file);
  out << text << std::flush;
  if (out) return absl::OkStatus();
  return absl::FailedPreconditionError(
      absl::StrCat((folder_ / file).string(), ": ", std::strerror(errno)));
}

absl::Status FigureData::Plot(const std::string& name, const std::string& script) const {
  const absl::Status written = Write(name + ".gp", script);
  return written.ok() ? RunGnuplot(folder_, name + ".gp") : written;
}

}  // namespace celt::cli
