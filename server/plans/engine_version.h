#pragma once

#include <cstdint>

namespace celt::plans {

/// Of all that numbers depend on: the mathematics, the plans and what they store. To be bumped with
/// every change after which a specification may give other bytes than before: what was stored under
/// another version is neither served as an answer nor gone on with.
inline constexpr std::int64_t kEngineVersion = 3;

}  // namespace celt::plans
