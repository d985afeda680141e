#pragma once

#include <string>

#include "celt/v1/job.pb.h"

namespace celt::cli {

/// A Lyapunov spectrum for people: exponents with as many digits as their errors support, the
/// mean return time, the dimension, and the paper's conditions with their margins.
std::string LyapunovTable(const v1::JobSpec& spec, const v1::LyapunovResult& result);

}  // namespace celt::cli
