// SPDX-License-Identifier: MIT
#include "remesh/quads/map/rounding.h"

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "base/fires.h"

namespace remesher {

namespace {

// Multiplications of one solution, which take about a second. A thousand integer variables and as
// many sums that are too small would take a hundred times as long.
constexpr double kMostWork = 1e9;

using Sparse = Eigen::SparseMatrix<double>;

template <class Visit>
void forEachEntry(const Sparse& matrix, Visit visit) {
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
    for (Sparse::InnerIterator it(matrix, column); it; ++it) visit(it.row(), it.col(), it.value());
}

// An order of the reals that keeps their factor sparse.
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

Eigen::MatrixXd inverseOf(const Eigen::MatrixXd& matrix) {
  return matrix.llt().solve(Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
}

}  // namespace

// The minimum of a quadratic of some variables, and the lower half of the inverse of its matrix.
// Variables that are fixed leave it. What moves take off the inverse waits until there are some:
// then each of its columns, which fill no cache together, is read once for all of them. Never
// inlined: one copy is enough.
class Minimum {
 public:
  Minimum(std::vector<int> variables, Eigen::VectorXd values, Eigen::MatrixXd inverse)
      : variables_(std::move(variables)),
        values_(std::move(values)),
        inverse_(std::move(inverse)),
        count_(values_.size()) {}

  Eigen::Index count() const { return count_; }
  int variable(Eigen::Index i) const { return variables_[std::size_t(i)]; }
  double value(Eigen::Index i) const { return values_[i]; }
  [[gnu::noinline]] Eigen::VectorXd column(Eigen::Index i) const {
    Eigen::VectorXd result(count_);
    for (Eigen::Index k = 0; k < count_; ++k) result[k] = inverse_(std::max(i, k), std::min(i, k));
    for (const Update& update : waiting_) {
      for (Eigen::Index k = 0; k < i; ++k) result[k] -= update.along[i] * update.share[k];
      for (Eigen::Index k = i; k < count_; ++k) result[k] -= update.along[k] * update.share[i];
    }
    return result;
  }

  // Moves to the minimum where a sum c·z is larger by `lack`. along: the inverse times c; spread:
  // c·along, and one over the weight of the wish if it is to be met in part [Woodbury].
  [[gnu::noinline]] void move(Eigen::VectorXd along, double lack, double spread) {
    values_.head(count_) += along * (lack / spread);
    Eigen::VectorXd share = along / spread;
    waiting_.push_back({std::move(along), std::move(share)});
    if (waiting_.size() == kAtOnce) update();
  }

  // The last variable takes the place of the fixed one.
  [[gnu::noinline]] void fix(Eigen::Index i, double value) {
    Eigen::VectorXd along = column(i);
    const double spread = along[i];
    move(std::move(along), value - values_[i], spread);
    const Eigen::VectorXd last = column(count_ - 1);
    --count_;
    variables_[std::size_t(i)] = variables_[std::size_t(count_)];
    values_[i] = values_[count_];
    for (Eigen::Index k = 0; k < count_; ++k) inverse_(std::max(i, k), std::min(i, k)) = last[k];
    if (i < count_) inverse_(i, i) = last[count_];
    for (Update& update : waiting_) update.along[i] = update.share[i] = 0;
  }

 private:
  struct Update {
    Eigen::VectorXd along, share;
  };
  static constexpr std::size_t kAtOnce = 8;

  void update() {
    for (Eigen::Index i = 0; i < count_; ++i)
      for (const Update& update : waiting_) {
        const double share = update.share[i];
        for (Eigen::Index k = i; k < count_; ++k) inverse_(k, i) -= update.along[k] * share;
      }
    waiting_.clear();
  }

  std::vector<int> variables_;
  Eigen::VectorXd values_;
  Eigen::MatrixXd inverse_;
  Eigen::Index count_;
  std::vector<Update> waiting_;
};

// The integer variables, and the wanted values of the required sums, 0 for none.
struct Rounding::Integers {
  Eigen::VectorXd relaxed, values;
  std::vector<int> wanted;
};

Rounding::Rounding(const Sparse& matrix, const Eigen::VectorXd& right, Eigen::Index reals)
    : reals_(reals), integers_(right.size() - reals), order_(sparseOrder(matrix, reals)) {
  all_.resize(std::size_t(integers_));
  std::iota(all_.begin(), all_.end(), 0);
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
  coupling_.resize(reals, integers_);
  coupling_.setFromTriplets(coupling.begin(), coupling.end());
  factor_.compute(ordered);
  if (factor_.info() != Eigen::Success) return;
  aim(right);
  // The part of A that is left without the reals stands at the end of the factor.
  Eigen::MatrixXd lower = Eigen::MatrixXd::Identity(integers_, integers_);
  forEachEntry(Sparse(factor_.matrixL()), [&](auto row, auto column, double value) {
    if (column >= reals && row >= reals) lower(row - reals, column - reals) = value;
  });
  matrix_ = lower * factor_.vectorD().tail(integers_).asDiagonal() * lower.transpose();
  inverse_ = inverseOf(matrix_);
  isSolvable_ = inverse_.allFinite() && relaxed_.allFinite();
}

void Rounding::aim(const Eigen::VectorXd& right) {
  right_ = right;
  for (Eigen::Index i = 0; i < reals_; ++i) right_[order_[i]] = right[i];
  relaxed_ = Eigen::VectorXd(factor_.solve(right_)).tail(integers_);
}

// Solves with the part of the factor that belongs to the reals.
template <class Right>
void Rounding::solveReals(Right& right) const {
  const Sparse& lower = factor_.matrixL().nestedExpression();
  const auto forBelow = [&](Eigen::Index column, auto visit) {
    for (Sparse::InnerIterator it(lower, column); it; ++it)
      if (it.row() > column && it.row() < reals_) visit(it.row(), it.value());
  };
  for (Eigen::Index i = 0; i < reals_; ++i)
    forBelow(i, [&](Eigen::Index row, double value) { right.row(row) -= value * right.row(i); });
  const Eigen::VectorXd diagonal = factor_.vectorD();
  for (Eigen::Index i = 0; i < reals_; ++i) right.row(i) /= diagonal[i];
  for (Eigen::Index i = reals_; i > 0; --i)
    forBelow(i - 1,
             [&](Eigen::Index row, double value) { right.row(i - 1) -= value * right.row(row); });
}

double Rounding::valueOf(const IntegerSum& terms, const Eigen::VectorXd& integers) const {
  double sum = 0;
  for (const auto& [variable, coefficient] : terms)
    sum += coefficient * integers[variable - reals_];
  return sum;
}

// The variables of a sum and those that move most with it, beside how far they move by chance.
std::vector<int> Rounding::allNear(const IntegerSum& sum, std::size_t count) const {
  Eigen::VectorXd along = Eigen::VectorXd::Zero(integers_);
  for (const auto& [variable, coefficient] : sum)
    along += coefficient * inverse_.col(variable - reals_);
  along.array() /= inverse_.diagonal().array().sqrt();
  std::vector<int> all = all_;
  const auto isNearer = [&](int a, int b) { return std::abs(along[a]) > std::abs(along[b]); };
  std::stable_sort(all.begin(), all.end(), isNearer);
  all.resize(std::min(all.size(), count));
  for (const auto& [variable, coefficient] : sum) all.push_back(int(variable - reals_));
  return all;
}

// About the multiplications for rounding so many variables.
double Rounding::workFor(const Integers& integers, std::size_t some) const {
  const auto own = double(some), all = double(integers_);
  const auto wanted = std::count_if(integers.wanted.begin(), integers.wanted.end(),
                                    [](int want) { return want != 0; });
  const double pulled = double(wanted) * own * own / 2;
  return pulled + (2 * own > all ? all * all * all / 3 : own * own * own + own * all);
}

// Of some variables, in their order, while the others stay. Few others are fixed one by one.
Minimum Rounding::minimumOf(const Integers& integers, const std::vector<int>& some) const {
  if (2 * Eigen::Index(some.size()) > integers_) {
    Minimum minimum(all_, integers.relaxed, inverse_);
    for (Eigen::Index i = integers_; i > 0; --i)
      if (!std::binary_search(some.begin(), some.end(), int(i - 1)))
        minimum.fix(i - 1, integers.values[i - 1]);
    return minimum;
  }
  const Eigen::VectorXd off = integers.values - integers.relaxed;
  const auto count = Eigen::Index(some.size());
  Eigen::MatrixXd own(count, count);
  Eigen::VectorXd slope(count), values(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const int at = some[std::size_t(i)];
    values[i] = integers.values[at];
    slope[i] = matrix_.col(at).dot(off);
    for (Eigen::Index k = 0; k < count; ++k) own(k, i) = matrix_(some[std::size_t(k)], at);
  }
  own = inverseOf(own);
  values -= own * slope;
  return {some, std::move(values), std::move(own)};
}

// Pulls a sum to its wanted value, by the variables of the minimum.
void Rounding::pullOne(Minimum& minimum, const Integers& integers, const IntegerSum& sum,
                       int wanted, double yield) const {
  std::vector<int> places(std::size_t(integers_), -1);
  for (Eigen::Index i = 0; i < minimum.count(); ++i)
    places[std::size_t(minimum.variable(i))] = int(i);
  const auto placeOf = [&](const auto& term) { return places[term.first - Index(reals_)]; };
  const auto isOne = [&](const auto& term) { return placeOf(term) >= 0; };
  if (std::none_of(sum.begin(), sum.end(), isOne)) return;
  double lack = wanted, spread = yield;
  Eigen::VectorXd along = Eigen::VectorXd::Zero(minimum.count());
  for (const auto& term : sum) {
    const int place = placeOf(term);
    lack -= term.second * (place < 0 ? integers.values[term.first - reals_] : minimum.value(place));
    if (place >= 0) along += term.second * minimum.column(place);
  }
  for (const auto& term : sum)
    if (isOne(term)) spread += term.second * along[placeOf(term)];
  minimum.move(std::move(along), lack, spread);
}

void Rounding::pull(Minimum& minimum, const Integers& integers,
                    std::span<const Wish> wishes) const {
  // One over the weight, beside weights of about 1.
  constexpr double kYield = 1e-3, kHardly = 1e-4;
  for (std::size_t k = 0; k < required_.size(); ++k)
    if (integers.wanted[k] != 0)
      pullOne(minimum, integers, required_[k], integers.wanted[k], kYield);
  for (const Wish& wish : wishes) pullOne(minimum, integers, wish.sum, wish.value, kHardly);
}

// Rounds these variables, the one nearest to an integer first; the others move to the new minimum,
// and so on.
void Rounding::round(Integers& integers, const std::vector<int>& some,
                     std::span<const Wish> wishes) const {
  Minimum minimum = minimumOf(integers, some);
  pull(minimum, integers, wishes);
  while (minimum.count() > 0) {
    Eigen::Index nearest = 0;
    double least = 1;
    for (Eigen::Index i = 0; i < minimum.count(); ++i) {
      const double away = std::abs(minimum.value(i) - std::round(minimum.value(i)));
      if (!(away < least)) continue;
      least = away;
      nearest = i;
    }
    const double whole = std::round(minimum.value(nearest));
    integers.values[minimum.variable(nearest)] = whole;
    minimum.fix(nearest, whole);
  }
}

// Wants more of the sums that are too small, and tells the variables near them.
std::vector<int> Rounding::pullShort(Integers& integers) const {
  // Some sums cannot all be 1: a sum is asked to be so much at most.
  constexpr int kFarthestPull = 4;
  constexpr std::size_t kNear = 40;
  std::vector<int> near;
  for (std::size_t k = 0; k < required_.size(); ++k) {
    int& wanted = integers.wanted[k];
    if (valueOf(required_[k], integers.values) >= 1 || wanted == kFarthestPull) continue;
    ++wanted;
    const std::vector<int> around = allNear(required_[k], kNear * std::size_t(wanted));
    near.insert(near.end(), around.begin(), around.end());
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

// Pulls the sums that are too small after rounding, and rounds the variables near them anew, until
// none is. Each round lets others fall below 1, or those pulled before: they are pulled farther,
// and more variables follow.
Eigen::VectorXd Rounding::roundedIntegers(double factor) const {
  const Eigen::VectorXd relaxed = factor * relaxed_;
  Integers integers{relaxed, relaxed, std::vector<int>(required_.size(), 0)};
  for (std::size_t k = 0; k < required_.size(); ++k)  // those that would become 0
    integers.wanted[k] = std::round(valueOf(required_[k], relaxed)) < 1;
  double work = 0;
  for (std::vector<int> some = all_; !some.empty(); some = pullShort(integers)) {
    if (work > kMostWork) {
      fires("quads: rounding ends early");
      break;
    }
    work += workFor(integers, some.size());
    round(integers, some, {});
  }
  work_ += work;
  return integers.values;
}

// Several columns at once: each takes the same way through the factor.
Eigen::MatrixXd Rounding::response() const {
  constexpr Eigen::Index kAtOnce = 8;
  using Block = Eigen::Matrix<double, Eigen::Dynamic, kAtOnce, Eigen::RowMajor>;
  Eigen::MatrixXd result(reals_, integers_);
  Block block(reals_, kAtOnce);
  for (Eigen::Index first = 0; first < integers_; first += kAtOnce) {
    const Eigen::Index count = std::min(kAtOnce, integers_ - first);
    block.setZero();
    for (Eigen::Index c = 0; c < count; ++c) block.col(c) = -coupling_.col(first + c);
    solveReals(block);
    for (Eigen::Index i = 0; i < reals_; ++i)
      result.row(i).segment(first, count) = block.row(order_[i]).head(count);
  }
  return result;
}

std::size_t Rounding::shortSums(const Eigen::VectorXd& integers) const {
  std::size_t count = 0;
  for (const IntegerSum& sum : required_) count += valueOf(sum, integers) < 0.5;
  return count;
}

Eigen::VectorXd Rounding::nudged(const Eigen::VectorXd& now, double factor,
                                 const Wish& wish) const {
  constexpr std::size_t kMoved = 12;
  Integers integers{factor * relaxed_, now, std::vector<int>(required_.size(), 0)};
  std::vector<int> some = allNear(wish.sum, kMoved);
  std::sort(some.begin(), some.end());
  some.erase(std::unique(some.begin(), some.end()), some.end());
  round(integers, some, {&wish, 1});
  return integers.values;
}

double Rounding::risen(const Eigen::VectorXd& integers, double factor) const {
  const Eigen::VectorXd off = integers - factor * relaxed_;
  return off.dot(matrix_ * off) / 2;
}

Eigen::VectorXd Rounding::withReals(const Eigen::VectorXd& integers, double factor) const {
  Eigen::VectorXd reals = factor * right_.head(reals_) - coupling_ * integers;
  solveReals(reals);
  Eigen::VectorXd result(right_.size());
  for (Eigen::Index i = 0; i < reals_; ++i) result[i] = reals[order_[i]];
  result.tail(integers_) = integers;
  return result;
}

Eigen::VectorXd Rounding::rounded(double factor) const {
  return withReals(roundedIntegers(factor), factor);
}

}  // namespace remesher
