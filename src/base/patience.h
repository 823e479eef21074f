// SPDX-License-Identifier: MIT
// Ends rounds towards a target number when each round gains too little: a mesh that allows one
// change per round would otherwise need as many rounds as it has vertices. And bounds work by what
// is done, not by time: so the bytes are the same on every machine.
#pragma once

#include <cstddef>
#include <limits>
#include <utility>

namespace remesher {

// A good round leaves at most 99 % of the missing number, so there are at most 100 · ln(missing)
// good rounds, and kBadRounds others.
class Patience {
 public:
  // Whether to continue after a round that made `done` changes and left `missing` to make.
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

// Counts down rounds that take something away, as long as those to come may take away all of it.
class Prospect {
 public:
  explicit Prospect(int rounds) : rounds_(rounds) {}

  // Asked before each round, with what is left now: whether another follows. Not if all would leave
  // some at the rate of the last two; one alone may leave more than there was.
  bool isGood(double left) {
    const double rate = (beforeLast_ - left) / 2;
    beforeLast_ = std::exchange(last_, left);
    return rounds_ > 0 && rate * rounds_-- >= left;
  }

 private:
  int rounds_;
  double last_ = std::numeric_limits<double>::infinity(), beforeLast_ = last_;
};

// Counted in places tried for a vertex.
class WorkBudget {
 public:
  WorkBudget() = default;  // without an end
  explicit WorkBudget(double places) : left_(places) {}

  void spend(double places) { left_ -= places; }
  bool isSpent() const { return left_ <= 0; }

 private:
  double left_ = std::numeric_limits<double>::infinity();
};

}  // namespace remesher
