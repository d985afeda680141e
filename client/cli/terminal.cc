#include "client/cli/terminal.h"

#include <cerrno>
#include <cstring>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "client/cli/format.h"

namespace celt::cli {
namespace {

constexpr char kEraseLine[] = "\r\x1b[K";

/// The first `width` characters.
std::string Cut(const std::string& text, int width) {
  int characters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    characters += Width(text.substr(i, 1));
    if (characters > width) return text.substr(0, i);
  }
  return text;
}

}  // namespace

Terminal::Terminal(std::ostream& out, std::ostream& err, int progress_width)
    : out_(out), err_(err), progress_width_(progress_width) {}

Terminal::~Terminal() { Erase(); }

absl::Status Terminal::Write(const std::string& text) {
  const std::lock_guard lock(mutex_);
  if (!written_.ok()) return written_;
  Erase();
  errno = 0;
  out_ << text << std::flush;
  if (!out_) {
    reader_left_ = errno == EPIPE;
    written_ = absl::InternalError(absl::StrCat("standard output: ", std::strerror(errno)));
  }
  return written_;
}

bool Terminal::reader_left() const {
  const std::lock_guard lock(mutex_);
  return reader_left_;
}

void Terminal::Say(const std::string& text) {
  const std::lock_guard lock(mutex_);
  Erase();
  err_ << "celt: " << absl::StrReplaceAll(text, {{"\n", " "}}) << std::endl;
}

void Terminal::Progress(const std::string& line) {
  const std::lock_guard lock(mutex_);
  if (progress_width_ <= 0) return;
  // The last column stays free: a terminal wraps when it is written to.
  progress_ = Cut(line, progress_width_ - 1);
  err_ << kEraseLine << progress_ << std::flush;
}

void Terminal::ClearProgress() {
  const std::lock_guard lock(mutex_);
  Erase();
}

void Terminal::Erase() {
  if (progress_.empty()) return;
  err_ << kEraseLine << std::flush;
  progress_.clear();
}

}  // namespace celt::cli
