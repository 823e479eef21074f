// SPDX-License-Identifier: MIT
#include "base/versioned_queue.h"

#include <doctest/doctest.h>

#include <map>
#include <random>

using namespace remesher;

TEST_CASE("versioned_queue: items come by their last keys, the largest first, ties by number") {
  std::mt19937 random(7);
  VersionedQueue queue;
  std::map<Index, double> keys;
  for (int step = 0; step < 3000; ++step) {
    const Index item = Index(random() % 40);
    const unsigned kind = unsigned(random() % 5);
    if (kind < 3) {
      const double key = double(random() % 16);
      queue.push(item, key);
      keys[item] = key;
    } else if (kind == 3) {
      queue.remove(item);
      keys.erase(item);
    } else {
      Index best = kNone;
      for (const auto& [known, key] : keys)
        if (best == kNone || key > keys[best]) best = known;
      REQUIRE(queue.pop() == best);
      keys.erase(best);
    }
  }
}
