// SPDX-License-Identifier: MIT
// Minimizes a quadratic some of whose variables must be integers: the variables nearest to integers
// are rounded, the others move to the new minimum, and so on [Bommes 2009]. Real variables are
// eliminated once, so that all of this runs on a dense matrix with a row for each integer variable.
#pragma once

#include <Eigen/SparseCholesky>
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

  // The solution for the right side times `factor`; integer variables are exact integers. Required
  // sums stay too small where pulling all of them would take too much work.
  Eigen::VectorXd rounded(double factor) const;

  // About as many multiplications as all calls of `rounded` took together.
  double work() const { return work_; }

 private:
  using Factor =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>;

  struct Wholes;
  double sumOf(std::size_t required, const Eigen::VectorXd& values) const;
  std::vector<int> allNear(std::size_t required, std::size_t count) const;
  double workFor(const Wholes& wholes, std::size_t some) const;
  Minimum minimumOf(const Wholes& wholes, const std::vector<int>& some) const;
  void pull(Minimum& minimum, const Wholes& wholes) const;
  void round(Wholes& wholes, const std::vector<int>& some) const;
  std::vector<int> pullShort(Wholes& wholes) const;
  Eigen::VectorXd roundedWholes(double factor) const;
  Eigen::VectorXd solveReals(Eigen::VectorXd right) const;

  Eigen::Index reals_, wholes_;
  std::vector<int> all_;   // the integer variables, from 0 on
  Eigen::VectorXi order_;  // of the reals: where each stands in the factor
  Factor factor_;
  Eigen::SparseMatrix<double> coupling_;  // rows of reals in the factor's order, columns of wholes
  Eigen::VectorXd right_;                 // in the factor's order
  Eigen::MatrixXd matrix_, inverse_;      // of the integer variables, without the reals
  Eigen::VectorXd relaxed_;               // the integer variables before rounding
  std::vector<IntegerSum> required_;
  bool isSolvable_ = false;
  mutable double work_ = 0;
};

}  // namespace remesher
