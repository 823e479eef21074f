// SPDX-License-Identifier: MIT
#include "geometry/piecewise.h"

#include <doctest/doctest.h>

#include "base/random.h"

using namespace remesher;

namespace {

Vec3 randomPoint(Random& random) { return {random.uniform(), random.uniform(), random.uniform()}; }

Triangle randomTriangle(Random& random) {
  return {randomPoint(random), randomPoint(random), randomPoint(random)};
}

Vec3 areaOf(const Piece& piece) {
  const auto corners = piece.corners();
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += areaVector(corners[0], corners[i - 1], corners[i]);
  return sum;
}

}  // namespace

TEST_CASE("piecewise: the parts of a cut piece make up the whole") {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Triangle whole = randomTriangle(random);
    std::vector<Piece> pieces = {Piece(whole)};
    for (int cuts = 0; cuts < 12; ++cuts) {
      const Piece piece = pieces.back();
      pieces.pop_back();
      cut(piece, randomTriangle(random), 0, pieces);
    }
    Vec3 sum = Vec3::Zero();
    for (const Piece& piece : pieces) {
      CHECK(piece.corners().size() >= 3);
      CHECK(piece.corners().size() <= Piece::kMostCorners);
      CHECK(areaOf(piece).dot(areaOf(Piece(whole))) >= -1e-12);
      sum += areaOf(piece);
    }
    CHECK((sum - areaOf(Piece(whole))).norm() < 1e-9);
  }
}

TEST_CASE("piecewise: every corner lies in the ball of its piece") {
  Random random(8);
  for (int i = 0; i < 50; ++i) {
    const Piece piece(randomTriangle(random));
    for (const Vec3& p : piece.corners())
      CHECK((p - piece.centre()).norm() <= piece.radius() * (1 + 1e-12));
  }
}

TEST_CASE("piecewise: a failure is found wherever it hides, and nowhere else") {
  // It holds where x < limit; of a piece that reaches beyond only its centre is known.
  const Triangle t = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const auto below = [](double limit) {
    return [limit](const Piece& piece) -> PieceFinding {
      if (piece.centre().x() >= limit) return {Finding::Fails};
      if (piece.centre().x() + piece.radius() < limit) return {Finding::Holds};
      return {};
    };
  };
  CHECK_FALSE(findFailure(t, {1e-4, 100'000}, below(1.01)));
  for (const double limit : {0.2, 0.5, 0.9, 0.99}) {
    const auto found = findFailure(t, {1e-4, 100'000}, below(limit));
    REQUIRE(found);
    CHECK(found->centre().x() >= limit - 1e-4);
  }
}

TEST_CASE("piecewise: what cannot be decided fails, by size or by number of pieces") {
  const Triangle t = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  std::size_t looks = 0;
  const auto unsure = [&](const Piece&) -> PieceFinding {
    ++looks;
    return {};
  };
  CHECK(findFailure(t, {0.1, 1'000'000}, unsure));
  CHECK(looks < 100);
  looks = 0;
  CHECK(findFailure(t, {0, 500}, unsure));
  CHECK(looks <= 501);
}
