// The one place that knows TOML.

#include <map>
#include <string_view>

#include "absl/strings/str_cat.h"
#include "server/config/config.h"
#include "server/jobs/status_macros.h"
#include "toml++/toml.h"

namespace celt::config {
namespace {

class Reader {
 public:
  Reader(const std::string& path, Config& config) : path_(path) {
    for (Setting& setting : SettingsOf(config)) settings_.emplace(setting.name, setting);
  }

  absl::Status Read(const toml::table& table, const std::string& prefix) const {
    for (const auto& [key, node] : table) {
      const std::string name = absl::StrCat(prefix, std::string(key.str()));
      absl::Status status =
          node.is_table() ? ReadTable(*node.as_table(), name) : ReadValue(node, name);
      if (!status.ok()) return status;
    }
    return absl::OkStatus();
  }

 private:
  absl::Status ReadTable(const toml::table& table, const std::string& name) const {
    const std::string prefix = name + ".";
    const auto first = settings_.lower_bound(prefix);
    if (first == settings_.end() || !first->first.starts_with(prefix)) {
      return At(table, absl::InvalidArgumentError(absl::StrCat(name, ": there is no such table")));
    }
    return Read(table, prefix);
  }

  absl::Status ReadValue(const toml::node& node, const std::string& name) const {
    const auto found = settings_.find(name);
    if (found == settings_.end()) {
      return At(node, absl::InvalidArgumentError(absl::StrCat(name, ": there is no such setting")));
    }
    return At(node, Set(found->second, node));
  }

  static absl::Status Set(const Setting& setting, const toml::node& node) {
    if (const auto* text = node.as_string()) return setting.Set(text->get());
    if (const auto* whole = node.as_integer()) return setting.Set(whole->get());
    if (const auto* number = node.as_floating_point()) return setting.Set(number->get());
    return absl::InvalidArgumentError(
        absl::StrCat(setting.name, ": a text or a number is expected"));
  }

  absl::Status At(const toml::node& node, const absl::Status& status) const {
    if (status.ok()) return status;
    return absl::InvalidArgumentError(
        absl::StrCat(path_, ":", node.source().begin.line, ": ", status.message()));
  }

  std::string path_;
  std::map<std::string, Setting> settings_;
};

}  // namespace

absl::Status ReadFile(const std::string& path, Config& config) {
  try {
    return Reader(path, config).Read(toml::parse_file(path), "");
  } catch (const toml::parse_error& error) {
    const auto line = error.source().begin.line;
    const std::string where = line > 0 ? absl::StrCat(path, ":", line) : path;
    return absl::InvalidArgumentError(absl::StrCat(where, ": ", std::string(error.description())));
  }
}

}  // namespace celt::config
