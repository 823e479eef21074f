// SPDX-License-Identifier: MIT
// Equations with whole coefficients, solved by elimination: each names one of its variables by the
// others. A variable that is to be whole is named by whole ones only, with whole coefficients, so
// that it is whole whenever those are.
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
  // Variables below `whole` are to be whole.
  IntegerRows(Index variables, Index whole)
      : definition_(variables), isDefined_(variables, 0), whole_(whole) {}

  // The sum is to be 0. False where no variable can be named by the others.
  [[nodiscard]] bool add(const IntegerSum& sum);

  // Names all variables by those that are left free: to be called once, after the last equation.
  void resolve();

  bool isFree(Index variable) const { return !isDefined_[variable]; }
  // The sum by free variables alone.
  IntegerSum reduced(IntegerSum sum) const;

 private:
  std::vector<IntegerSum> definition_;
  std::vector<char> isDefined_;
  std::vector<Index> order_;  // of the definitions
  Index whole_;
};

}  // namespace remesher
