// The entry for libFuzzer, in a build by Clang with -fsanitize=fuzzer. In every build the corpus
// beside it is run by corpus_test.cc.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  celt::fuzz::TakeApart({reinterpret_cast<const char*>(data), size});
  return 0;
}
