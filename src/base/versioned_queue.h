// SPDX-License-Identifier: MIT
// A priority queue of numbered items whose keys change. A new key supersedes the old one, whose
// entry is skipped when its turn comes (lazy deletion): nothing is searched for.
#pragma once

#include <queue>
#include <vector>

#include "base/types.h"

namespace remesher {

class VersionedQueue {
 public:
  // Enters an item, or gives it another key.
  void push(Index item, double key) {
    remove(item);
    entries_.push({key, item, versions_[item]});
  }

  // Takes out an item, if it is in the queue.
  void remove(Index item) {
    if (versions_.size() <= item) versions_.resize(std::size_t{item} + 1, 0);
    ++versions_[item];
  }

  // Takes out the item with the largest key, of several the lowest one; kNone if there is none.
  Index pop() {
    while (!entries_.empty()) {
      const Entry entry = entries_.top();
      entries_.pop();
      if (entry.version != versions_[entry.item]) continue;
      remove(entry.item);
      return entry.item;
    }
    return kNone;
  }

 private:
  struct Entry {
    double key;
    Index item, version;
    bool operator<(const Entry& other) const {
      return key != other.key ? key < other.key : item > other.item;
    }
  };

  std::priority_queue<Entry> entries_;
  std::vector<Index> versions_;  // per item how often it was entered or taken out
};

}  // namespace remesher
