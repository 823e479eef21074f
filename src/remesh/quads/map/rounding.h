// SPDX-License-Identifier: MIT
// Minimizes a quadratic some of whose variables must be integers: the variables nearest to integers
// are rounded, the others move to the new minimum, and so on [Bommes 2009]. Real variables are
// eliminated once, so that all of this runs on a dense matrix with a row for each integer variable.
#pragma once

#include <Eigen/SparseCholesky>
#include <span>
#include <utility>
#include <vector>

#include "remesh/quads/map/integer_rows.h"

namespace remesher {

class Minimum;  // of some variables

class Rounding {
 public:
  // The quadratic ½ x·A·x − b·x. matrix: the lower half of A; right: b. Variables below `reals` may
  // be any numbers.
  Rounding(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& right,
           Eigen::Index reals);

  // Whether A could be factored.
  bool isSolvable() const { return isSolvable_; }

  // Takes another b.
  void aim(const Eigen::VectorXd& right);

  // Sums of integer variables that should be at least 1.
  void require(std::vector<IntegerSum> sums) { required_ = std::move(sums); }

  // A sum of integer variables that should have a value.
  struct Wish {
    IntegerSum sum;
    int value = 0;
  };

  // The solution for the right side times `factor`; integer variables are exact integers. Required
  // sums stay too small where pulling all of them would take too much work.
  Eigen::VectorXd rounded(double factor) const;

  // The solution with these integer variables.
  Eigen::VectorXd withReals(const Eigen::VectorXd& integers, double factor) const;

  // How the reals of a solution move with each integer variable.
  Eigen::MatrixXd response() const;

  // Gives a sum another value: the integer variables that move most with it are rounded anew.
  Eigen::VectorXd nudged(const Eigen::VectorXd& integers, double factor, const Wish& wish) const;

  // By how much the quadratic is larger than its minimum over real variables.
  double risen(const Eigen::VectorXd& integers, double factor) const;

  // The number of required sums that are too small.
  std::size_t shortSums(const Eigen::VectorXd& integers) const;

  // A sum of integer variables, as they are and before rounding.
  double valueOf(const IntegerSum& sum, const Eigen::VectorXd& integers) const;
  double relaxed(const IntegerSum& sum, double factor) const {
    return factor * valueOf(sum, relaxed_);
  }

  // About as many multiplications as all calls of `rounded` took together.
  double work() const { return work_; }

 private:
  using Factor =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>;

  struct Integers;
  std::vector<int> allNear(const IntegerSum& sum, std::size_t count) const;
  double workFor(const Integers& integers, std::size_t some) const;
  Minimum minimumOf(const Integers& integers, const std::vector<int>& some) const;
  void pullOne(Minimum& minimum, const Integers& integers, const IntegerSum& sum, int wanted,
               double yield) const;
  void pull(Minimum& minimum, const Integers& integers, std::span<const Wish> wishes) const;
  void round(Integers& integers, const std::vector<int>& some, std::span<const Wish> wishes) const;
  std::vector<int> pullShort(Integers& integers) const;
  Eigen::VectorXd roundedIntegers(double factor) const;
  template <class Right>
  void solveReals(Right& right) const;

  Eigen::Index reals_, integers_;
  std::vector<int> all_;   // the integer variables, from 0 on
  Eigen::VectorXi order_;  // of the reals: where each stands in the factor
  Factor factor_;
  Eigen::SparseMatrix<double>
      coupling_;                      // rows of reals in the factor's order, columns of integers
  Eigen::VectorXd right_;             // in the factor's order
  Eigen::MatrixXd matrix_, inverse_;  // of the integer variables, without the reals
  Eigen::VectorXd relaxed_;           // the integer variables before rounding
  std::vector<IntegerSum> required_;
  bool isSolvable_ = false;
  mutable double work_ = 0;
};

}  // namespace remesher
