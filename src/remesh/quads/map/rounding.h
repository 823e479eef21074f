// SPDX-License-Identifier: MIT
// The least of a quadratic some of whose variables are to be whole: those nearest to whole numbers
// are rounded first, and then all others are where the least is now, and so on [Bommes 2009]. Real
// variables are eliminated once, so that all of that is done on a dense matrix with a row for each
// whole variable.
#pragma once

#include <Eigen/SparseCholesky>
#include <utility>
#include <vector>

#include "remesh/quads/map/integer_rows.h"

namespace remesher {

class Rounding {
 public:
  // ½ x·A·x − b·x, the lower half of A; variables below `reals` may be any numbers.
  Rounding(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& right,
           Eigen::Index reals);

  // Whether A could be factored.
  bool isSolvable() const { return isSolvable_; }

  // Sums of variables that are to be whole are to be 1 at least.
  void require(std::vector<IntegerSum> sums) { required_ = std::move(sums); }

  // For the right side times a factor: all variables, those that are to be whole exactly so.
  Eigen::VectorXd rounded(double factor) const;

 private:
  using Factor =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>;

  struct Wholes {
    Eigen::VectorXd values;
    Eigen::MatrixXd inverse;  // of the matrix that is left for them
  };
  void pull(Wholes& wholes, const std::vector<char>& isPulled) const;
  void roundAll(Wholes& wholes) const;
  Wholes roundedWholes(double factor) const;
  Eigen::VectorXd solveReals(Eigen::VectorXd right) const;

  Eigen::Index reals_, wholes_;
  Eigen::VectorXi order_;  // of the reals: where each stands in the factor
  Factor factor_;
  Eigen::SparseMatrix<double> coupling_;  // rows of reals in the factor's order, columns of wholes
  Eigen::VectorXd right_;                 // in the factor's order
  Eigen::MatrixXd inverse_;               // of what is left when reals are eliminated
  Eigen::VectorXd relaxed_;               // where the least is if nothing need be whole
  std::vector<IntegerSum> required_;
  bool isSolvable_ = false;
};

}  // namespace remesher
