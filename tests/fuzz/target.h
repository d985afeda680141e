#pragma once

#include <string_view>

namespace celt::fuzz {

/// What a client can send, taken apart: the first byte says as what (a specification, or a page
/// token), the rest is it. Aborts when a promise is broken: what is resolved resolves to itself,
/// every resolved specification has a plan, and a token that is taken comes back as it was.
void TakeApart(std::string_view input);

}  // namespace celt::fuzz
