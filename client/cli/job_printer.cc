#include "client/cli/job_printer.h"

#include <string>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/strip.h"
#include "absl/time/time.h"
#include "client/cli/csv.h"
#include "client/cli/format.h"
#include "client/cli/json.h"
#include "client/cli/text_table.h"

namespace celt::cli {
namespace {

using Properties = std::vector<std::pair<std::string, std::string>>;

std::string StateText(v1::Job::State state) {
  const std::string& name = v1::Job::State_Name(state);
  return absl::AsciiStrToLower(absl::StripPrefix(name, "STATE_"));
}

std::string TimeText(bool has, const google::protobuf::Timestamp& time) {
  if (!has) return "";
  const absl::Time moment = absl::FromUnixSeconds(time.seconds()) + absl::Nanoseconds(time.nanos());
  return absl::FormatTime("%Y-%m-%dT%H:%M:%SZ", moment, absl::UTCTimeZone());
}

std::string Percentage(const v1::Progress& progress) {
  if (!(progress.total() > 0)) return "";
  return absl::StrFormat("%.0f%%", 100 * progress.done() / progress.total());
}

Properties PropertiesOf(const v1::Job& job) {
  return {{"id", job.id()},
          {"state", StateText(job.state())},
          {"analysis", AnalysisField(job.spec())},
          {"system", SystemTitle(job.spec().system())},
          {"progress", Percentage(job.progress())},
          {"records", absl::StrCat(job.last_sequence())},
          {"created", TimeText(job.has_create_time(), job.create_time())},
          {"ended", TimeText(job.has_end_time(), job.end_time())},
          {"error", job.error().message()}};
}

std::vector<std::string> Names(const Properties& properties) {
  std::vector<std::string> names;
  for (const auto& property : properties) names.push_back(property.first);
  return names;
}

std::vector<std::string> Values(const Properties& properties) {
  std::vector<std::string> values;
  for (const auto& property : properties) values.push_back(property.second);
  return values;
}

std::string JsonLines(const std::vector<v1::Job>& jobs) {
  std::string text;
  for (const v1::Job& job : jobs) absl::StrAppend(&text, ToJson("job", job), "\n");
  return text;
}

std::string CsvRows(const std::vector<v1::Job>& jobs) {
  std::string text;
  for (const v1::Job& job : jobs) absl::StrAppend(&text, CsvLine(Values(PropertiesOf(job))));
  return text;
}

std::string Table(const std::vector<v1::Job>& jobs) {
  TextTable table(Names(PropertiesOf({})));
  for (const v1::Job& job : jobs) table.Add(Values(PropertiesOf(job)));
  return table.Text();
}

}  // namespace

JobPrinter::JobPrinter(OutputFormat format, Terminal& terminal)
    : format_(format), terminal_(terminal) {}

absl::Status JobPrinter::Print(const std::vector<v1::Job>& jobs) {
  if (format_ == OutputFormat::kJson) return terminal_.Write(JsonLines(jobs));
  if (format_ == OutputFormat::kTable) return terminal_.Write(Table(jobs));
  const std::string header = header_printed_ ? "" : CsvLine(Names(PropertiesOf({})));
  header_printed_ = true;
  return terminal_.Write(header + CsvRows(jobs));
}

absl::Status JobPrinter::PrintOne(const v1::Job& job) {
  if (format_ != OutputFormat::kTable) return Print({job});
  TextTable table({});
  for (const auto& [name, value] : PropertiesOf(job)) {
    if (!value.empty()) table.Add({name, value});
  }
  return terminal_.Write(table.Text());
}

}  // namespace celt::cli
