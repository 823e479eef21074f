// SPDX-License-Identifier: MIT
// Equations with integer coefficients, solved by elimination: each equation expresses one of its
// variables by the others. An integer variable is expressed by integer variables only, with integer
// coefficients, so that its value is an integer whenever theirs are.
#pragma once

#include <utility>
#include <vector>

#include "base/types.h"

namespace remesher {

// Σ coefficient · variable, by ascending variables; no coefficient is 0.
using IntegerSum = std::vector<std::pair<Index, int>>;

// a + factor · b.
IntegerSum plus(const IntegerSum& a, const IntegerSum& b, int factor);

class IntegerRows {
 public:
  // Variables below `whole` must be integers.
  IntegerRows(Index variables, Index whole)
      : definition_(variables), isDefined_(variables, 0), whole_(whole) {}

  // Adds the equation sum = 0. False if no variable can be expressed by the others.
  [[nodiscard]] bool add(const IntegerSum& sum);

  // Expresses all variables by the free ones. Call once, after the last equation.
  void resolve();

  bool isFree(Index variable) const { return !isDefined_[variable]; }
  // The same sum in free variables alone.
  IntegerSum reduced(IntegerSum sum) const;

 private:
  std::vector<IntegerSum> definition_;
  std::vector<char> isDefined_;
  std::vector<Index> order_;  // of the definitions
  Index whole_;
};

}  // namespace remesher
