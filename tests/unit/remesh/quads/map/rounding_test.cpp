// SPDX-License-Identifier: MIT
#include "remesh/quads/map/rounding.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/soups.h"

using namespace remesher;

namespace {

// A row of values that are to be 1 apart, the ends and every third of which are to be whole.
struct Row {
  static constexpr Index kReals = 20, kIntegers = 6;
  Eigen::SparseMatrix<double> matrix{kReals + kIntegers, kReals + kIntegers};
  Eigen::VectorXd right = Eigen::VectorXd::Zero(kReals + kIntegers);

  explicit Row(std::uint64_t seed) {
    soups::Random random(seed);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(kReals + kIntegers, kReals + kIntegers);
    const auto placeOf = [](Index i) { return i % 4 == 3 ? kReals + i / 4 : i - (i + 1) / 4; };
    for (Index i = 0; i + 1 < kReals + kIntegers; ++i) {
      const Index a = placeOf(i), b = placeOf(i + 1);
      const double wanted = 0.5 + random.number(), weight = 0.5 + random.number();
      dense(a, a) += weight, dense(b, b) += weight;
      dense(std::max(a, b), std::min(a, b)) -= weight;
      right[a] -= weight * wanted, right[b] += weight * wanted;
    }
    dense.diagonal().array() += 1e-6;
    matrix = dense.sparseView();
  }

  double energy(const Eigen::VectorXd& x) const {
    return 0.5 * x.dot(matrix.selfadjointView<Eigen::Lower>() * x) - right.dot(x);
  }
};

}  // namespace

TEST_CASE("rounding: what is to be whole is, and the rest is where the least is then") {
  for (std::uint64_t seed = 1; seed < 12; ++seed) {
    const Row row(seed);
    const Rounding rounding(row.matrix, row.right, Row::kReals);
    REQUIRE(rounding.isSolvable());
    const Eigen::VectorXd x = rounding.rounded(1);
    for (Index i = Row::kReals; i < x.size(); ++i) CHECK(x[i] == std::round(x[i]));
    const Eigen::VectorXd slope = row.matrix.selfadjointView<Eigen::Lower>() * x - row.right;
    CHECK(slope.head(Row::kReals).cwiseAbs().maxCoeff() < 1e-8);
  }
}

TEST_CASE("rounding: sums that cannot all be met end, and their work is counted") {
  const Row row(3);
  Rounding rounding(row.matrix, row.right, Row::kReals);
  REQUIRE(rounding.isSolvable());
  CHECK(rounding.work() == 0);
  rounding.rounded(1);
  const double plain = rounding.work();
  CHECK(plain > 0);
  const Index first = Row::kReals, second = Row::kReals + 1;
  rounding.require({{{first, 1}, {second, -1}}, {{first, -1}, {second, 1}}});
  const Eigen::VectorXd x = rounding.rounded(1);
  for (Index i = Row::kReals; i < x.size(); ++i) CHECK(x[i] == std::round(x[i]));
  CHECK(rounding.work() > 3 * plain);  // its own once, and each sum pulled more than once
}

TEST_CASE("rounding: one whole variable after the other is no worse than all at once") {
  double greedy = 0, atOnce = 0;
  for (std::uint64_t seed = 1; seed < 30; ++seed) {
    const Row row(seed);
    const Rounding rounding(row.matrix, row.right, Row::kReals);
    greedy += row.energy(rounding.rounded(1));
    // All at once: where the least is without integers, rounded, and the reals solved for again.
    const Eigen::MatrixXd lower = row.matrix;
    const Eigen::MatrixXd full = lower.selfadjointView<Eigen::Lower>();
    Eigen::VectorXd x = full.ldlt().solve(row.right);
    for (Index i = Row::kReals; i < x.size(); ++i) x[i] = std::round(x[i]);
    const Eigen::Index n = Row::kReals;
    x.head(n) = full.topLeftCorner(n, n).ldlt().solve(
        row.right.head(n) - full.topRightCorner(n, Row::kIntegers) * x.tail(Row::kIntegers));
    atOnce += row.energy(x);
  }
  CHECK(greedy <= atOnce);
}

TEST_CASE("rounding: aimed elsewhere it is as made for there") {
  for (std::uint64_t seed = 1; seed < 12; ++seed) {
    const Row row(seed);
    const Eigen::VectorXd right = Row(seed + 12).right;
    Rounding aimed(row.matrix, row.right, Row::kReals);
    aimed.aim(right);
    CHECK(aimed.rounded(1) == Rounding(row.matrix, right, Row::kReals).rounded(1));
  }
}

TEST_CASE("rounding: a sum that is to be 1 at least is, where it would be 0 without") {
  int helped = 0;
  for (std::uint64_t seed = 1; seed < 12; ++seed) {
    const Row row(seed);
    Rounding rounding(row.matrix, row.right, Row::kReals);
    constexpr double kSmall = 0.1;  // of the scale: neighbours that are whole meet
    const auto gap = [&] {
      const Eigen::VectorXd x = rounding.rounded(kSmall);
      return x[Row::kReals + 1] - x[Row::kReals];
    };
    helped += gap() < 1;
    rounding.require({{{Row::kReals, -1}, {Row::kReals + 1, 1}}});
    CHECK(gap() >= 1);
  }
  CHECK(helped > 0);
}

TEST_CASE("rounding: in a long row every gap that would be 0 or 1 is 1, and none is more") {
  // Each variable is wanted 0 to 0.6 after the one before.
  constexpr Index kCount = 120;
  soups::Random random(7);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(kCount, kCount);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(kCount);
  std::vector<IntegerSum> gaps;
  for (Index i = 0; i + 1 < kCount; ++i) {
    const double wanted = 0.6 * random.number(), weight = 0.5 + random.number();
    dense(i, i) += weight, dense(i + 1, i + 1) += weight, dense(i + 1, i) -= weight;
    right[i] -= weight * wanted, right[i + 1] += weight * wanted;
    gaps.push_back({{i, -1}, {i + 1, 1}});
  }
  dense.diagonal().array() += 1e-6;
  Rounding rounding(dense.sparseView(), right, 0);
  rounding.require(gaps);
  const Eigen::VectorXd x = rounding.rounded(1);
  for (Index i = 0; i + 1 < kCount; ++i) CHECK(x[i + 1] - x[i] == 1);
}
