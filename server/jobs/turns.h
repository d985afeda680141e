#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace celt::jobs {

/// A line in which owners share time evenly, and the items of one owner do: of the owners who wait,
/// the one who has used least goes first, and of theirs the item that has; the earlier one where
/// they are level. Who comes, or comes back, begins level with who went last: idle time is not
/// saved up. Not safe to use from several threads.
template <class Item>
class Turns {
 public:
  /// Puts an item in the line.
  void Push(const std::string& owner, const Item& item) {
    Owner& its = owners_[owner];
    if (its.waiting.empty()) its.used = std::max(its.used, level_);
    const auto entry = its.used_by.try_emplace(item, its.level).first;
    entry->second = std::max(entry->second, its.level);
    its.waiting.push_back(entry);
  }

  /// Takes the item whose turn it is among those that are wanted.
  template <class Wanted>
  std::optional<Item> Pop(Wanted wanted) {
    Owner* its = nullptr;
    std::size_t place = 0;
    for (auto& [name, owner] : owners_) {
      if (its != nullptr && its->used <= owner.used) continue;
      if (const std::size_t next = owner.Next(wanted); next < owner.waiting.size()) {
        its = &owner;
        place = next;
      }
    }
    if (its == nullptr) return std::nullopt;
    level_ = std::max(level_, its->used);
    return its->Take(place);
  }

  /// Counts time that an item has used, or gives back what was counted too much (negative). Whether
  /// it is in the line or not.
  void Charge(const std::string& owner, const Item& item, double seconds) {
    const auto its = owners_.find(owner);
    if (its == owners_.end()) return;
    its->second.used += seconds;
    const auto entry = its->second.used_by.find(item);
    if (entry != its->second.used_by.end()) entry->second += seconds;
  }

  /// The item will not come back.
  void Forget(const std::string& owner, const Item& item) {
    const auto found = owners_.find(owner);
    if (found == owners_.end()) return;
    Owner& its = found->second;
    if (const auto entry = its.used_by.find(item); entry != its.used_by.end()) {
      std::erase(its.waiting, entry);
      its.used_by.erase(entry);
    }
    // One who has used more than others does not begin level with them.
    if (its.used_by.empty() && its.used <= level_) owners_.erase(found);
  }

 private:
  using Entry = typename std::map<Item, double>::iterator;  // an item, and seconds

  struct Owner {
    /// The place of the one whose turn it is; behind the last when none is wanted.
    template <class Wanted>
    std::size_t Next(Wanted wanted) const {
      std::size_t next = waiting.size();
      for (std::size_t i = 0; i < waiting.size(); ++i) {
        if (next < waiting.size() && waiting[next]->second <= waiting[i]->second) continue;
        if (wanted(waiting[i]->first)) next = i;
      }
      return next;
    }

    Item Take(std::size_t place) {
      const Entry entry = waiting[place];
      waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(place));
      level = std::max(level, entry->second);
      return entry->first;
    }

    double used = 0;   // seconds
    double level = 0;  // of the item that went last
    std::map<Item, double> used_by;
    std::vector<Entry> waiting;
  };

  double level_ = 0;  // of the owner who went last
  std::map<std::string, Owner> owners_;
};

}  // namespace celt::jobs
