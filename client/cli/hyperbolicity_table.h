#pragma once

#include <string>

#include "celt/v1/job.pb.h"

namespace celt::cli {

/// The tests of pseudo-hyperbolicity for people: exponents, which test passed with what margin, the
/// angles and their trend, the LMP graph, and the verdict in a sentence.
std::string HyperbolicityTable(const v1::JobSpec& spec, const v1::HyperbolicityResult& result);

}  // namespace celt::cli
