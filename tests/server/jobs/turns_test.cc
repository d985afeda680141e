#include "server/jobs/turns.h"

#include <map>
#include <string>

#include "gtest/gtest.h"

namespace celt::jobs {
namespace {

/// Items of owners, each of which comes back at once; `seconds` each of their turns takes.
struct Line {
  void Push(const std::string& owner, char item, double seconds) {
    items[item] = {owner, seconds};
    turns.Push(owner, item);
  }
  std::string Take(int count) {
    std::string order;
    for (int i = 0; i < count; ++i) {
      const char item = *turns.Pop([](char) { return true; });
      const auto& [owner, seconds] = items[item];
      turns.Charge(owner, item, seconds);
      turns.Push(owner, item);
      order += item;
    }
    return order;
  }

  Turns<char> turns;
  std::map<char, std::pair<std::string, double>> items;
};

TEST(Turns, LetsOwnersTakeTurnsHoweverManyItemsTheyHave) {
  Line line;
  for (const char item : {'a', 'b', 'c'}) line.Push("anna", item, 1);
  line.Push("boris", 'x', 1);
  EXPECT_EQ(line.Take(8), "axbxcxax");
}

TEST(Turns, SharesTimeAndNotTurns) {
  Line line;
  line.Push("anna", 'a', 3);
  line.Push("anna", 'b', 1);
  EXPECT_EQ(line.Take(8), "abbbabbb");
  Line owners;
  owners.Push("anna", 'a', 3);
  owners.Push("boris", 'x', 1);
  EXPECT_EQ(owners.Take(8), "axxxaxxx");
}

TEST(Turns, LetsNobodySaveUpTimeOrComeBackAfresh) {
  Line line;
  line.Push("anna", 'a', 1);
  line.Take(100);
  line.Push("boris", 'x', 1);
  line.Push("anna", 'b', 1);
  // From the level of the last turn on; 'a' has had that one.
  EXPECT_EQ(line.Take(6), "xbxaxb");
  line.turns.Charge("boris", 'x', 2);
  line.turns.Forget("boris", 'x');
  line.Push("boris", 'y', 1);
  EXPECT_EQ(line.Take(4), "abya");
}

TEST(Turns, GivesOnlyWhatIsWantedAndForgets) {
  Line line;
  for (const char item : {'a', 'b', 'c'}) line.Push("anna", item, 1);
  EXPECT_EQ(line.turns.Pop([](char item) { return item > 'a'; }), 'b');
  line.turns.Forget("anna", 'a');
  line.turns.Forget("anna", 'b');
  EXPECT_EQ(line.turns.Pop([](char) { return true; }), 'c');
  EXPECT_EQ(line.turns.Pop([](char) { return true; }), std::nullopt);
}

}  // namespace
}  // namespace celt::jobs
