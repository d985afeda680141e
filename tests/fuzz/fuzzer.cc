// For libFuzzer: cmake --preset fuzz && cmake --build --preset fuzz &&
// build/fuzz/tests/fuzz/celt_fuzz tests/fuzz/corpus

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  celt::fuzz::TakeApart({reinterpret_cast<const char*>(data), size});
  return 0;
}
