#include "server/jobs/turns.h"

#include <string>

#include "gtest/gtest.h"

namespace celt::jobs {
namespace {

std::string PopAll(Turns<char>& turns) {
  std::string order;
  while (!turns.empty()) order += turns.Pop();
  return order;
}

TEST(Turns, LetsOwnersTakeTurnsHoweverManyItemsTheyHave) {
  Turns<char> turns;
  for (const char item : {'a', 'b', 'c', 'd'}) turns.Push("anna", item);
  turns.Push("boris", 'x');
  turns.Push("clara", 'y');
  EXPECT_EQ(PopAll(turns), "axybcd");
}

TEST(Turns, PutsAnOwnerWhoComesBackAtTheEnd) {
  Turns<char> turns;
  turns.Push("anna", 'a');
  turns.Push("boris", 'x');
  EXPECT_EQ(turns.Pop(), 'a');
  turns.Push("anna", 'b');
  EXPECT_EQ(PopAll(turns), "xb");
}

}  // namespace
}  // namespace celt::jobs
