#include "server/jobs/page_token.h"

#include <charconv>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace celt::jobs {
namespace {

constexpr int kBase = 16;

/// Reads all of `text` as a number without a sign.
template <class Number>
bool Parse(std::string_view text, Number& number) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number, kBase);
  return error == std::errc() && stop == end && number >= 0;
}

}  // namespace

std::string Encode(const PageToken& token) {
  return absl::StrCat(absl::Hex(token.before_serial), ".", absl::Hex(token.states));
}

absl::StatusOr<PageToken> DecodePageToken(std::string_view text) {
  PageToken token;
  const std::size_t dot = text.find('.');
  if (dot == std::string_view::npos || !Parse(text.substr(0, dot), token.before_serial) ||
      !Parse(text.substr(dot + 1), token.states)) {
    return absl::InvalidArgumentError("page_token: not one that this server gave");
  }
  return token;
}

}  // namespace celt::jobs
