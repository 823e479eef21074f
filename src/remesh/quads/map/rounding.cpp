// SPDX-License-Identifier: MIT
#include "remesh/quads/map/rounding.h"

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <algorithm>
#include <cmath>
#include <vector>

namespace remesher {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

template <class Visit>
void forEachEntry(const Sparse& matrix, Visit visit) {
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
    for (Sparse::InnerIterator it(matrix, column); it; ++it) visit(it.row(), it.col(), it.value());
}

// An order of the reals in which a factor of theirs stays sparse.
Eigen::VectorXi sparseOrder(const Sparse& matrix, Eigen::Index reals) {
  std::vector<Eigen::Triplet<double>> entries;
  forEachEntry(matrix, [&](auto row, auto column, double value) {
    if (row < reals && column < reals) entries.emplace_back(row, column, value);
  });
  Sparse block(reals, reals);
  block.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order(reals);
  const Sparse full = block.selfadjointView<Eigen::Lower>();
  Eigen::AMDOrdering<int>()(full, order);
  Eigen::VectorXi place(reals);
  for (int i = 0; i < int(reals); ++i) place[order.indices()[i]] = i;
  return place;
}

}  // namespace

Rounding::Rounding(const Sparse& matrix, const Eigen::VectorXd& right, Eigen::Index reals)
    : reals_(reals), wholes_(right.size() - reals), order_(sparseOrder(matrix, reals)) {
  const auto placeOf = [&](Eigen::Index i) { return i < reals ? Eigen::Index(order_[i]) : i; };
  std::vector<Eigen::Triplet<double>> entries, coupling;
  forEachEntry(matrix, [&](auto row, auto column, double value) {
    const Eigen::Index a = placeOf(row), b = placeOf(column);
    entries.emplace_back(std::max(a, b), std::min(a, b), value);
    if (std::max(a, b) >= reals && std::min(a, b) < reals)
      coupling.emplace_back(std::min(a, b), std::max(a, b) - reals, value);
  });
  Sparse ordered(right.size(), right.size());
  ordered.setFromTriplets(entries.begin(), entries.end());
  coupling_.resize(reals, wholes_);
  coupling_.setFromTriplets(coupling.begin(), coupling.end());
  right_.resize(right.size());
  for (Eigen::Index i = 0; i < right.size(); ++i) right_[placeOf(i)] = right[i];
  factor_.compute(ordered);
  if (factor_.info() != Eigen::Success) return;
  relaxed_ = Eigen::VectorXd(factor_.solve(right_)).tail(wholes_);
  // What eliminating the reals leaves of A stands at the end of the factor.
  Eigen::MatrixXd lower = Eigen::MatrixXd::Identity(wholes_, wholes_);
  forEachEntry(Sparse(factor_.matrixL()), [&](auto row, auto column, double value) {
    if (column >= reals && row >= reals) lower(row - reals, column - reals) = value;
  });
  const Eigen::MatrixXd left =
      lower * factor_.vectorD().tail(wholes_).asDiagonal() * lower.transpose();
  inverse_ = left.llt().solve(Eigen::MatrixXd::Identity(wholes_, wholes_));
  isSolvable_ = inverse_.allFinite() && relaxed_.allFinite();
}

// By the part of the factor that is that of the reals.
Eigen::VectorXd Rounding::solveReals(Eigen::VectorXd right) const {
  const Sparse& lower = factor_.matrixL().nestedExpression();
  const auto forBelow = [&](Eigen::Index column, auto visit) {
    for (Sparse::InnerIterator it(lower, column); it; ++it)
      if (it.row() > column && it.row() < reals_) visit(it.row(), it.value());
  };
  for (Eigen::Index i = 0; i < right.size(); ++i)
    forBelow(i, [&](Eigen::Index row, double value) { right[row] -= value * right[i]; });
  right.array() /= factor_.vectorD().head(reals_).array();
  for (Eigen::Index i = right.size(); i > 0; --i)
    forBelow(i - 1, [&](Eigen::Index row, double value) { right[i - 1] -= value * right[row]; });
  return right;
}

// A sum c·z that would round to less than 1 is pulled to 1: by a weight w the least is where
// z + w (1 − c·z) / (1 + w c·C·c) C·c is, C the inverse [Sherman & Morrison].
void Rounding::pull(Wholes& wholes) const {
  constexpr double kShort = 0.75, kWeight = 1e3;  // of a quad's side; beside weights of about 1
  for (const IntegerSum& sum : required_) {
    Eigen::VectorXd c = Eigen::VectorXd::Zero(wholes_);
    for (const auto& [variable, coefficient] : sum) c[variable - reals_] = coefficient;
    const double now = c.dot(wholes.values);
    if (now >= kShort) continue;
    const Eigen::VectorXd column = wholes.inverse * c;
    const double share = kWeight / (1 + kWeight * c.dot(column));
    wholes.values += share * (1 - now) * column;
    wholes.inverse.noalias() -= share * column * column.transpose();
  }
}

void Rounding::roundAll(Wholes& all) const {
  auto& [wholes, inverse] = all;
  std::vector<char> isRounded(std::size_t(wholes_), 0);
  for (Eigen::Index round = 0; round < wholes_; ++round) {
    Eigen::Index nearest = -1;
    double least = 1;
    for (Eigen::Index i = 0; i < wholes.size(); ++i) {
      const double away = std::abs(wholes[i] - std::round(wholes[i]));
      if (isRounded[std::size_t(i)] || away >= least) continue;
      nearest = i;
      least = away;
    }
    isRounded[std::size_t(nearest)] = 1;
    const double whole = std::round(wholes[nearest]), own = inverse(nearest, nearest);
    const Eigen::VectorXd column = inverse.col(nearest);
    wholes += column * ((whole - wholes[nearest]) / own);
    wholes[nearest] = whole;
    inverse.noalias() -= column * (column / own).transpose();
  }
  for (double& x : wholes) x = std::round(x);
}

Eigen::VectorXd Rounding::rounded(double factor) const {
  Wholes all{factor * relaxed_, inverse_};
  pull(all);
  roundAll(all);
  const Eigen::VectorXd reals = solveReals(factor * right_.head(reals_) - coupling_ * all.values);
  Eigen::VectorXd result(right_.size());
  for (Eigen::Index i = 0; i < reals_; ++i) result[i] = reals[order_[i]];
  result.tail(wholes_) = all.values;
  return result;
}

}  // namespace remesher
