#pragma once

#include <deque>
#include <map>
#include <string>
#include <utility>

namespace celt::jobs {

/// A line in which owners take turns, and the items of one owner do. Not safe to use from several
/// threads.
template <class Item>
class Turns {
 public:
  bool empty() const { return owners_.empty(); }

  /// Puts an item at the end of its owner's line, and an owner who had none at the end of theirs.
  void Push(const std::string& owner, Item item) {
    std::deque<Item>& line = items_[owner];
    if (line.empty()) owners_.push_back(owner);
    line.push_back(std::move(item));
  }

  /// Takes the first item of the owner whose turn it is. Precondition: not empty.
  Item Pop() {
    const std::string owner = std::move(owners_.front());
    owners_.pop_front();
    const auto line = items_.find(owner);
    Item item = std::move(line->second.front());
    line->second.pop_front();
    if (line->second.empty()) {
      items_.erase(line);
    } else {
      owners_.push_back(owner);
    }
    return item;
  }

 private:
  std::deque<std::string> owners_;  // of those with items
  std::map<std::string, std::deque<Item>> items_;
};

}  // namespace celt::jobs
