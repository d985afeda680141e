#pragma once

#include <string_view>

namespace celt::fuzz {

/// What a client can send, taken apart: the first byte says as what (a specification, the token of
/// a page, or where a stream goes on), the rest is it. Aborts when a promise is broken: what is
/// resolved resolves to itself, every resolved specification has a plan, a token that is taken
/// comes back as it was, and a stream goes on with what comes after.
void TakeApart(std::string_view input);

}  // namespace celt::fuzz
