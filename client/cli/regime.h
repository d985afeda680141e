#pragma once

#include <string>

#include "celt/v1/lyapunov.pb.h"

namespace celt::cli {

/// A regime in words; "not told" when it is unspecified.
std::string RegimeName(v1::Regime regime);

}  // namespace celt::cli
