#include "client/cli/terminal.h"

#include <cerrno>
#include <sstream>
#include <streambuf>

#include "gtest/gtest.h"

namespace celt::cli {
namespace {

/// Fails every write with an errno.
class BrokenBuffer : public std::streambuf {
 public:
  explicit BrokenBuffer(int error) : error_(error) {}

 private:
  std::streamsize xsputn(const char* /*text*/, std::streamsize /*size*/) override {
    errno = error_;
    return 0;
  }
  int error_;
};

TEST(Terminal, ProgressStepsAsideForData) {
  std::ostringstream both;
  {
    Terminal terminal(both, both, 80);
    terminal.Progress("50%");
    static_cast<void>(terminal.Write("data\n"));
  }
  EXPECT_EQ(both.str(), "\r\x1b[K50%\r\x1b[Kdata\n");
}

TEST(Terminal, ProgressIsErasedAtTheEnd) {
  std::ostringstream out;
  std::ostringstream err;
  { Terminal(out, err, 80).Progress("99%"); }
  EXPECT_EQ(err.str(), "\r\x1b[K99%\r\x1b[K");
  EXPECT_EQ(out.str(), "");
}

TEST(Terminal, ProgressNeverFillsTheLine) {
  std::ostringstream out;
  std::ostringstream err;
  Terminal terminal(out, err, 5);
  terminal.Progress("Λ234567");
  EXPECT_EQ(err.str(), "\r\x1b[KΛ234");
}

TEST(Terminal, WithoutTerminalThereIsNoProgress) {
  std::ostringstream out;
  std::ostringstream err;
  { Terminal(out, err, 0).Progress("99%"); }
  EXPECT_EQ(err.str(), "");
}

TEST(Terminal, MessageIsOneLine) {
  std::ostringstream out;
  std::ostringstream err;
  Terminal(out, err, 0).Say("energy: too low\nby far");
  EXPECT_EQ(err.str(), "celt: energy: too low by far\n");
}

TEST(Terminal, FailedWriteIsReportedAndStays) {
  BrokenBuffer buffer(ENOSPC);
  std::ostream out(&buffer);
  std::ostringstream err;
  Terminal terminal(out, err, 0);
  EXPECT_EQ(terminal.Write("x"), absl::InternalError("standard output: No space left on device"));
  EXPECT_FALSE(terminal.Write("y").ok());
  EXPECT_FALSE(terminal.reader_left());
}

TEST(Terminal, ClosedPipeIsNoErrorOfOurs) {
  BrokenBuffer buffer(EPIPE);
  std::ostream out(&buffer);
  std::ostringstream err;
  Terminal terminal(out, err, 0);
  EXPECT_FALSE(terminal.Write("x").ok());
  EXPECT_TRUE(terminal.reader_left());
}

}  // namespace
}  // namespace celt::cli
