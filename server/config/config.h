#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "absl/status/status.h"

namespace celt::config {

/// All that a server can be told, with its defaults. Sizes that are 0 are without limit.
struct Config {
  std::string listen = "127.0.0.1:7350";
  std::string http = "127.0.0.1:7351";
  std::string data_dir;
  std::int64_t workers = 0;
  double drain_seconds = 10;

  struct Limits {
    std::int64_t iterates = 1'000'000'000'000;
    std::int64_t nodes = 10'000'000;
    std::int64_t records = 10'000'000;
    double computing_hours = 0;
    std::int64_t unfinished_jobs = 10'000;
    std::int64_t unfinished_jobs_per_owner = 1'000;
  } limits;

  struct Retention {
    double record_days = 0;
    double job_days = 0;
    std::int64_t store_megabytes = 0;
  } retention;

  struct Store {
    std::string synchronous = "normal";
  } store;

  struct Access {
    std::string tokens;
    std::string certificate;
    std::string key;
    std::string client_ca;
  } access;

  struct Log {
    std::string level = "info";
    std::string format = "text";
  } log;
};

/// One of them: how it is called, what it means, and what it may be.
struct Setting {
  using Place = std::variant<std::string*, std::int64_t*, double*>;

  std::string name;  ///< in the file; the part before a dot is the table's
  std::string help;
  Place place;
  double highest = 0;                     ///< of a number; the lowest is 0
  std::vector<std::string> choices = {};  ///< of a text; empty: any

  /// On the command line: "--limits-unfinished-jobs".
  std::string Flag() const;
  /// INVALID_ARGUMENT "name: value is not allowed; …".
  absl::Status Set(std::string value) const;
  absl::Status Set(std::int64_t value) const;
  absl::Status Set(double value) const;
};

/// Every setting of `config`, which must outlive them.
std::vector<Setting> SettingsOf(Config& config);

/// Takes what a TOML file says over what `config` has. INVALID_ARGUMENT begins with "path:line: ".
absl::Status ReadFile(const std::string& path, Config& config);

/// What settings must be together: without both TLS and a way to tell owners apart, a server
/// listens on loopback only. INVALID_ARGUMENT names the setting.
absl::Status Check(const Config& config);

}  // namespace celt::config
