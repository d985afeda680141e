#pragma once

#include <memory>
#include <string>

#include "client/cli/analysis.h"

namespace celt::cli {

/// `celt separatrix`.
std::unique_ptr<Analysis> MakeSeparatrix();

/// The bracket for people, with what becomes of the separatrix on either side.
std::string SeparatrixTable(const v1::JobSpec& spec, const v1::SeparatrixResult& result);

}  // namespace celt::cli
