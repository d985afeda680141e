#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "core/analysis/manifold.h"

namespace celt::plans {

/// A side under way as bytes and back, exactly. DATA_LOSS: the bytes are not what was written.
std::string EncodeSide(const ManifoldSide& side);
absl::StatusOr<ManifoldSide> DecodeSide(std::string_view bytes, int dimension);

}  // namespace celt::plans
