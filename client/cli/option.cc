#include "client/cli/option.h"

#include <algorithm>

#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/cli/parse.h"

namespace celt::cli {
namespace {

/// `parse` makes the target's value, or a status, of the text.
template <typename Target, typename Parse>
void Add(CLI::App& app, const std::string& name, Target& target, const Help& help, Parse parse) {
  app.add_option_function<std::string>(
         name,
         [&target, name, parse](const std::string& text) {
           auto value = parse(text);
           if (!value.ok()) throw CLI::ValidationError(name, std::string(value.status().message()));
           target = *std::move(value);
         },
         help.text)
      ->group(help.group)
      ->type_name(help.value);
}

absl::StatusOr<int> IndexOf(const std::string& text, const std::vector<std::string>& words) {
  const auto found = std::find(words.begin(), words.end(), text);
  if (found != words.end()) return static_cast<int>(found - words.begin());
  return absl::InvalidArgumentError(
      absl::StrCat("'", text, "' is none of ", absl::StrJoin(words, ", ")));
}

}  // namespace

void AddNumber(CLI::App& app, const std::string& name, std::optional<double>& target,
               const Help& help) {
  Add(app, name, target, help, ParseNumber);
}

void AddInteger(CLI::App& app, const std::string& name, std::optional<std::int64_t>& target,
                const Help& help, const IntegerRange& range) {
  Add(app, name, target, help,
      [range](const std::string& text) { return ParseInteger(text, range.lowest, range.highest); });
}

void AddUnsigned(CLI::App& app, const std::string& name, std::optional<std::uint64_t>& target,
                 const Help& help) {
  Add(app, name, target, help, ParseUnsigned);
}

void AddNumbers(CLI::App& app, const std::string& name, const std::vector<std::string>& names,
                std::optional<std::vector<double>>& target, const Help& help) {
  Add(app, name, target, help,
      [names](const std::string& text) { return ParseNumbers(text, names); });
}

void AddChoice(CLI::App& app, const std::string& name, const std::vector<std::string>& words,
               std::optional<int>& target, const Help& help) {
  Add(app, name, target, help, [words](const std::string& text) { return IndexOf(text, words); });
}

}  // namespace celt::cli
