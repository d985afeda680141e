#include "client/cli/estimate.h"

#include <cmath>

#include "absl/strings/str_cat.h"
#include "client/cli/csv.h"
#include "client/cli/format.h"
#include "client/cli/json.h"
#include "client/cli/text_table.h"

namespace celt::cli {
namespace {

constexpr int kDigits = 2;  // an estimate has no more

std::string Duration(double seconds) {
  constexpr double kMinute = 60;
  if (seconds < kMinute) return absl::StrCat(Significant(seconds, kDigits), " s");
  return Clock(absl::Seconds(seconds));
}

std::string Amounts(const v1::Estimate& estimate) {
  std::string text;
  if (estimate.iterates() > 0) {
    absl::StrAppend(&text, Grouped(std::llround(estimate.iterates())), " iterates");
  }
  if (estimate.most_units() > 0) {
    absl::StrAppend(&text, text.empty() ? "" : " in ", Grouped(estimate.most_units()),
                    estimate.most_units() == 1 ? " unit" : " units");
  }
  return text;
}

std::string Table(const v1::Job& job) {
  if (!job.id().empty()) return absl::StrCat("  ", KnownText(job), "\n");
  const v1::Estimate& estimate = job.estimate();
  const std::string amounts = Amounts(estimate);
  TextTable table({});
  if (!amounts.empty()) table.Add({"work", amounts});
  table.Add({"computes for", absl::StrCat("about ", Duration(estimate.seconds()))});
  table.Add({"other jobs", estimate.queue_seconds() > 0
                               ? absl::StrCat("about ", Duration(estimate.queue_seconds()))
                               : "none"});
  return table.Text();
}

std::string Csv(const v1::Job& job) {
  const v1::Estimate& estimate = job.estimate();
  return CsvLine({"most_units", "iterates", "seconds", "queue_seconds", "known_by"}) +
         CsvLine({absl::StrCat(estimate.most_units()), Shortest(estimate.iterates()),
                  Shortest(estimate.seconds()), Shortest(estimate.queue_seconds()), job.id()});
}

}  // namespace

absl::Duration UntilEnd(const v1::Estimate& estimate) {
  return absl::Seconds(estimate.seconds() + estimate.queue_seconds());
}

std::string EstimateText(const v1::Estimate& estimate) {
  std::string text = absl::StrCat("about ", Duration(estimate.seconds()));
  const std::string amounts = Amounts(estimate);
  if (!amounts.empty()) absl::StrAppend(&text, ": ", amounts);
  if (estimate.queue_seconds() > 0) {
    absl::StrAppend(&text, "; ", Duration(estimate.queue_seconds()),
                    " of other jobs before or beside it");
  }
  return text;
}

std::string KnownText(const v1::Job& job) {
  return absl::StrCat("known already, by job ", job.id(), "; --fresh computes it anew");
}

std::string EstimateReport(const v1::Job& job, OutputFormat format) {
  if (format == OutputFormat::kTable) return Table(job);
  if (format == OutputFormat::kCsv) return Csv(job);
  return ToJson("job", job) + "\n";
}

}  // namespace celt::cli
