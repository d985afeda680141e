#pragma once

#include <mutex>
#include <ostream>
#include <string>

#include "absl/status/status.h"

namespace celt::cli {

enum class OutputFormat { kTable, kJson, kCsv };

/// Standard output and standard error as one: data goes to the one, messages and a progress line to
/// the other, and the progress line steps aside for both. Safe to use from many threads.
class Terminal {
 public:
  /// `progress_width`: columns for the progress line; 0 shows none.
  Terminal(std::ostream& out, std::ostream& err, int progress_width);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Writes data and flushes it. Not OK (INTERNAL) when it can't be written, now or before.
  absl::Status Write(const std::string& text);
  /// Whether Write failed because nobody reads any more, which is no error of ours.
  bool reader_left() const;

  /// Writes "celt: <text>" as one line.
  void Say(const std::string& text);

  bool shows_progress() const { return progress_width_ > 0; }
  /// Replaces the progress line.
  void Progress(const std::string& line);
  void ClearProgress();

 private:
  void Erase();

  std::ostream& out_;
  std::ostream& err_;
  const int progress_width_;
  mutable std::mutex mutex_;
  std::string progress_;
  absl::Status written_;
  bool reader_left_ = false;
};

}  // namespace celt::cli
