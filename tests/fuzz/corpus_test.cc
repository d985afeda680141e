// What the fuzzer has found so far, run again.

#include <filesystem>
#include <fstream>
#include <sstream>

#include "gtest/gtest.h"
#include "tests/fuzz/target.h"

namespace celt::fuzz {
namespace {

TEST(Corpus, BreaksNoPromise) {
  int inputs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CELT_CORPUS)) {
    SCOPED_TRACE(entry.path());
    std::ostringstream input;
    input << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    TakeApart(input.str());
    ++inputs;
  }
  EXPECT_GT(inputs, 20);
}

}  // namespace
}  // namespace celt::fuzz
