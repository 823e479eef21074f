// SPDX-License-Identifier: MIT
// What keeps rounds towards a number from going on for ever where each does but a little: a mesh
// that allows one change a round would ask for as many rounds as vertices.
#pragma once

#include <cstddef>

namespace remesher {

// Every good round leaves at most 99 % of what was missing, so there are at most 100 · ln(missing)
// of those, and kBadRounds others.
class Patience {
 public:
  // Whether to go on after a round that did `done` and left `missing`.
  bool after(std::size_t done, std::size_t missing) {
    if (done == 0 || missing == 0) return false;
    if (kGoodShare * done < missing && ++badRounds_ >= kBadRounds) return false;
    return true;
  }

 private:
  static constexpr std::size_t kGoodShare = 100;
  static constexpr int kBadRounds = 32;
  int badRounds_ = 0;
};

}  // namespace remesher
