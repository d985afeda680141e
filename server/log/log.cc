#include "server/log/log.h"

#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>

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

/// Of a value's. A line of all fields is then shorter than PIPE_BUF, and clients that send long
/// names do not fill the log.
constexpr std::size_t kLongestValue = 1000;

/// As JSON wants it; what clients send can't end a line or a string.
std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (quoted.size() > kLongestValue) return quoted + "...\"";
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
  if (text.size() > kLongestValue) return false;
  for (const char c : text) {
    if (c <= ' ' || c == '"' || c == '=' || c == '\\') return false;
  }
  return true;
}

/// Whether a line of up to PIPE_BUF bytes can be written without waiting for whoever reads them.
bool TakesALine() {
  pollfd file = {STDERR_FILENO, POLLOUT, 0};
  return poll(&file, 1, 0) > 0;
}

std::string AsLine(std::string_view event, const Fields& fields) {
  return json ? AsJson(event, fields) : AsText(event, fields);
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
  static std::mutex mutex;
  static std::int64_t lost = 0;  // under mutex
  const std::string line = AsLine(event, fields);
  const std::lock_guard lock(mutex);
  if (lost > 0 && TakesALine()) {
    to->log(spdlog::level::warn, "{}", AsLine("log lines lost", {{"lines", absl::StrCat(lost)}}));
    lost = 0;
  }
  if (!TakesALine()) {
    ++lost;
    return;
  }
  to->log(ToSpdlog(level), "{}", line);
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
