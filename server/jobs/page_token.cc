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
  return absl::StrCat(absl::Hex(token.created), ".", absl::Hex(token.states), ".", token.id);
}

absl::StatusOr<PageToken> DecodePageToken(std::string_view text) {
  PageToken token;
  const std::size_t first = text.find('.');
  const std::size_t second = first == std::string_view::npos ? first : text.find('.', first + 1);
  if (second == std::string_view::npos || second + 1 == text.size() ||
      !Parse(text.substr(0, first), token.created) ||
      !Parse(text.substr(first + 1, second - first - 1), token.states)) {
    return absl::InvalidArgumentError("page_token: not one that this server gave");
  }
  token.id = text.substr(second + 1);
  return token;
}

}  // namespace celt::jobs
