#include "server/log/log.h"

#include <atomic>
#include <memory>

#include "absl/strings/str_cat.h"
#include "spdlog/sinks/stdout_color_sinks.h"
#include "spdlog/spdlog.h"

namespace celt::log {
namespace {

std::atomic<bool> json = false;
std::atomic<spdlog::logger*> logger = nullptr;

spdlog::level::level_enum ToSpdlog(Level level) {
  switch (level) {
    case Level::kDebug:
      return spdlog::level::debug;
    case Level::kInfo:
      return spdlog::level::info;
    case Level::kWarning:
      return spdlog::level::warn;
    case Level::kError:
      return spdlog::level::err;
    case Level::kCritical:
      break;
  }
  return spdlog::level::critical;
}

/// As JSON wants it; what clients send can't end a line or a string.
std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += {'\\', c};
    } else if (static_cast<unsigned char>(c) < ' ') {
      absl::StrAppend(&quoted, "\\u", absl::Hex(static_cast<unsigned char>(c), absl::kZeroPad4));
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

bool IsPlain(std::string_view text) {
  for (const char c : text) {
    if (c <= ' ' || c == '"' || c == '=' || c == '\\') return false;
  }
  return true;
}

}  // namespace

void SetUp(const std::string& level, const std::string& format) {
  static const std::shared_ptr<spdlog::logger> made = spdlog::stderr_color_mt("celtd");
  json = format == "json";
  made->set_level(spdlog::level::from_str(level));
  made->set_pattern(json ? R"({"time":"%Y-%m-%dT%H:%M:%S.%e%z","level":"%l",%v})"
                         : "%Y-%m-%d %H:%M:%S.%e %^%l%$ %v");
  logger = made.get();
}

void Write(Level level, std::string_view event, const Fields& fields) {
  spdlog::logger* const to = logger;
  if (to == nullptr || !to->should_log(ToSpdlog(level))) return;
  to->log(ToSpdlog(level), "{}", json ? AsJson(event, fields) : AsText(event, fields));
}

std::string AsText(std::string_view event, const Fields& fields) {
  std::string line(event);
  for (const auto& [name, value] : fields) {
    if (value.empty()) continue;
    absl::StrAppend(&line, " ", std::string(name), "=", IsPlain(value) ? value : Quoted(value));
  }
  return line;
}

std::string AsJson(std::string_view event, const Fields& fields) {
  std::string line = absl::StrCat("\"event\":", Quoted(event));
  for (const auto& [name, value] : fields) {
    if (value.empty()) continue;
    absl::StrAppend(&line, ",", Quoted(name), ":", Quoted(value));
  }
  return line;
}

}  // namespace celt::log
