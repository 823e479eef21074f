// SPDX-License-Identifier: MIT
#include "arrangement/arrangement.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/place.h"
#include "geometry/triangle.h"
#include "measure/self_intersections.h"
#include "mesh/mesh_builder.h"
#include "mesh/used_vertices.h"
#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"
#include "support/volume_of.h"

using namespace remesher;
using shapes::volumeOf;

namespace {

using Outcome = ArrangementResult::Outcome;

// The bodies, one operand each unless they are all one; equal positions are one point.
ArrangementInput inputOf(const std::vector<TriangleMesh>& bodies, bool isEachAnOperand = false) {
  TriangleMesh all;
  ArrangementInput input;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto operand = isEachAnOperand ? Index(b) : Index{0};
    input.operands.insert(input.operands.end(), bodies[b].triangleCount(), operand);
    all = soups::joined({all, bodies[b]});
  }
  const std::vector<Index> first = weld(all.positions);
  std::vector<Index> numbers(first.size(), kNone);
  for (const Index corner : all.indices) {
    Index& number = numbers[first[corner]];
    if (number == kNone) {
      number = Index(input.positions.size());
      input.positions.push_back(all.positions[first[corner]]);
    }
    input.indices.push_back(number);
  }
  return input;
}

ArrangementInput inputOf(const TriangleMesh& mesh) { return inputOf(std::vector{mesh}); }

double volumeOf(const ArrangementResult& result) {
  return shapes::volumeOf(result.positions, result.indices);
}

TriangleMesh meshOf(const ArrangementResult& result) {
  TriangleMesh mesh;
  mesh.positions = result.positions;
  mesh.indices = result.indices;
  return mesh;
}

// Whether as many triangles run along each edge one way as the other, by position.
bool isClosed(const ArrangementResult& result) {
  std::map<std::pair<std::array<double, 3>, std::array<double, 3>>, int> sums;
  const auto place = [&](std::size_t corner) {
    const Vec3& p = result.positions[result.indices[corner]];
    return std::array{p.x(), p.y(), p.z()};
  };
  for (std::size_t i = 0; i < result.indices.size(); ++i) {
    const auto a = place(i), b = place(i % 3 == 2 ? i - 2 : i + 1);
    a < b ? ++sums[{a, b}] : --sums[{b, a}];
  }
  return std::all_of(sums.begin(), sums.end(), [](const auto& sum) { return sum.second == 0; });
}

using Corners = std::array<std::array<double, 3>, 3>;

// By position, the least corner first.
std::multiset<Corners> trianglesOf(const std::vector<Vec3>& positions,
                                   const std::vector<Index>& indices) {
  std::multiset<Corners> result;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    Corners c;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = positions[indices[i + k]];
      c[k] = {p.x(), p.y(), p.z()};
    }
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    result.insert(c);
  }
  return result;
}

// The laws that hold for every result.
void checkSound(const ArrangementInput& input, const ArrangementResult& result) {
  REQUIRE(result.outcome == Outcome::Done);
  CHECK(isClosed(result));
  CHECK(result.selfIntersections.empty());
  CHECK(selfIntersections(meshOf(result)).empty());
  REQUIRE(result.triangles.size() == result.indices.size() / 3);
  REQUIRE(result.positions.size() >= input.positions.size());
  for (std::size_t v = 0; v < input.positions.size(); ++v)
    REQUIRE(result.positions[v] == input.positions[v]);
  double size = 0;
  for (const Vec3& p : input.positions) size = std::max(size, p.norm());
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    const ArrangedTriangle& triangle = result.triangles[t];
    REQUIRE(triangle.parent < input.operands.size());
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 sum = Vec3::Zero();
      for (std::size_t i = 0; i < 3; ++i)
        sum += triangle.weights[k][Eigen::Index(i)] *
               input.positions[input.indices[3 * triangle.parent + i]];
      REQUIRE((sum - result.positions[result.indices[3 * t + k]]).norm() < 1e-6 * size);
    }
  }
}

ArrangementResult arranged(const ArrangementInput& input, InsideRule rule = isWound,
                           bool isSingle = false) {
  ArrangementOptions options;
  options.isInside = std::move(rule);
  options.isSingle = isSingle;
  ArrangementResult result = arrange(input, options);
  checkSound(input, result);
  return result;
}

bool inEither(std::span<const int> w) { return w[0] > 0 || w[1] > 0; }
bool inBoth(std::span<const int> w) { return w[0] > 0 && w[1] > 0; }
bool inFirstOnly(std::span<const int> w) { return w[0] > 0 && w[1] <= 0; }

TriangleMesh box(const Vec3& low, const Vec3& high) {
  TriangleMesh mesh = soups::cube(0, 1);
  for (Vec3& p : mesh.positions) p = low + p.cwiseProduct(high - low);
  return mesh;
}

// A pyramid on a square, which faces outwards.
TriangleMesh pyramid(double base, double apex) {
  TriangleMesh mesh;
  mesh.positions = {{1, 0, base}, {0, 1, base}, {-1, 0, base}, {0, -1, base}, {0, 0, apex}};
  mesh.indices = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 2, 1, 0, 3, 2, 0};
  return apex > base ? mesh : shapes::turnedOver(mesh);
}

// By a random rotation and shift, in single precision.
TriangleMesh anywhere(TriangleMesh mesh, soups::Random& random) {
  Eigen::Quaterniond turn(random.number() - 0.5, random.number() - 0.5, random.number() - 0.5,
                          random.number() - 0.5);
  turn.normalize();
  const Vec3 by = random.point();
  for (Vec3& p : mesh.positions) p = inSingle(turn * p + by, {});
  return mesh;
}

// A tube around a figure of eight in the plane: it crosses itself once.
TriangleMesh figureOfEight(int n, int m) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, n, m, [&](int i, int k) {
    const double u = 2 * std::numbers::pi * (i % n) / n;
    const Vec3 center(2 * std::cos(u), std::sin(2 * u), 0);
    const Vec3 along = Vec3(-2 * std::sin(u), 2 * std::cos(2 * u), 0).normalized();
    const Vec3 circle = shapes::onCircle(k, m);
    return Vec3(center +
                0.3 * (circle.x() * along.cross(Vec3::UnitZ()) + circle.y() * Vec3::UnitZ()));
  });
  return shapes::volumeOf(mesh) < 0 ? shapes::turnedOver(mesh) : mesh;
}

}  // namespace

TEST_CASE("arrangement: what meets nothing comes back bit for bit") {
  for (const TriangleMesh& mesh :
       {shapes::icosphere(4), shapes::torus(12, 8), shapes::boxWithHole(), shapes::cylinder(12, 3),
        soups::joined({soups::cube(0, 1), soups::cube(2, 3)}),
        soups::joined({shapes::icosphere(3),
                       shapes::turnedOver(shapes::scaled(shapes::icosphere(2), 0.5))})}) {
    const ArrangementInput input = inputOf(mesh);
    const ArrangementResult result = arranged(input);
    CHECK(result.indices == input.indices);
    CHECK(result.positions == input.positions);
    CHECK(result.cut == 0);
    CHECK(result.dropped == 0);
  }
}

TEST_CASE("arrangement: boxes in general position, with the exact volumes") {
  const ArrangementInput input =
      inputOf({box({0, 0, 0}, {4, 4, 4}), box({1, 2, 3}, {6, 7, 8})}, true);
  const ArrangementResult either = arranged(input, inEither);
  CHECK(volumeOf(either) == doctest::Approx(64 + 125 - 6).epsilon(1e-14));
  CHECK(either.indices.size() <= 3 * 60);
  CHECK(volumeOf(arranged(input, inBoth)) == doctest::Approx(6).epsilon(1e-14));
  CHECK(arranged(input, inBoth).indices.size() == 3 * 12);
  CHECK(volumeOf(arranged(input, inFirstOnly)) == doctest::Approx(64 - 6).epsilon(1e-14));
}

TEST_CASE("arrangement: bodies that overlap by a rounding touch at a point") {
  for (const double height : {0.1, 0.2, 0.5}) {
    const ArrangementInput input =
        inputOf({pyramid(1 - height, 1 + 0x1p-52), pyramid(1 + height, 1)});
    const ArrangementResult result = arranged(input);
    CHECK(result.triangles.size() == input.operands.size());
    CHECK(volumeOf(result) == doctest::Approx(2 * 2 * height / 3));
  }
  // A deeper overlap keeps its ring of facets.
  const ArrangementInput deep = inputOf({pyramid(0, 1.25), pyramid(2, 1)});
  CHECK(arranged(deep).triangles.size() > deep.operands.size());
}

TEST_CASE("arrangement: a point that rounding puts beside an edge leaves no needle there") {
  const Eigen::AngleAxisd turn(0.3, Vec3::UnitZ());
  for (const double shift : {0.0, 0.1, 0.37}) {
    TriangleMesh ground = box({-1, -1, -1}, {1, 1, 0}), tip = pyramid(1, 0);
    for (TriangleMesh* mesh : {&ground, &tip})
      for (Vec3& p : mesh->positions) p = turn * p + Vec3(shift, 0, shift);
    const ArrangementResult result = arranged(inputOf({ground, tip}));
    double thinnest = 1;
    for (std::size_t i = 0; i < result.indices.size(); i += 3) {
      const auto at = [&](std::size_t k) { return result.positions[result.indices[i + k]]; };
      thinnest = std::min(thinnest, area(at(0), at(1), at(2)));
    }
    CHECK(thinnest > 0.1);
  }
}

TEST_CASE("arrangement: boxes that share parts of their faces") {
  struct Case {
    const char* name;
    Vec3 low, high;
    double shared;
    std::size_t most;  // triangles of the union
  };
  const std::vector<Case> cases = {
      {"side by side", {4, 0, 0}, {8, 4, 4}, 0, 20},
      {"a smaller one on a face", {1, 1, 4}, {3, 3, 6}, 0, 28},
      {"overlapping in a plane", {2, 2, 0}, {6, 6, 4}, 16, 30},
      {"half way along a side", {4, 2, 0}, {8, 6, 4}, 0, 30},
      {"identical", {0, 0, 0}, {4, 4, 4}, 64, 12},
      {"one within the other, from the same corner", {0, 0, 0}, {2, 2, 2}, 8, 12},
      {"nested", {1, 1, 1}, {2, 2, 2}, 1, 12},
      {"touching in an edge", {4, 4, 0}, {8, 8, 4}, 0, 24},
      {"touching in a part of an edge", {4, 4, 1}, {8, 8, 3}, 0, 28},
      {"touching in a corner", {4, 4, 4}, {8, 8, 8}, 0, 24},
      {"apart", {5, 5, 5}, {8, 8, 8}, 0, 24}};
  for (const Case& c : cases) {
    INFO(c.name);
    const ArrangementInput input = inputOf({box({0, 0, 0}, {4, 4, 4}), box(c.low, c.high)}, true);
    const double own = 64, other = (c.high - c.low).prod();
    const ArrangementResult either = arranged(input, inEither), both = arranged(input, inBoth);
    CHECK(volumeOf(either) == doctest::Approx(own + other - c.shared).epsilon(1e-14));
    CHECK(volumeOf(both) == doctest::Approx(c.shared).epsilon(1e-14));
    CHECK(volumeOf(arranged(input, inFirstOnly)) == doctest::Approx(own - c.shared).epsilon(1e-14));
    CHECK(either.triangles.size() <= c.most);
    if (c.shared == 0) CHECK(both.triangles.empty());
  }
}

TEST_CASE("arrangement: a flat body has no inside") {
  CHECK(arranged(inputOf(shapes::doubledSheet(3))).triangles.empty());
  CHECK(arranged(inputOf(shapes::flatBalloon(3))).triangles.empty());
  CHECK(arranged(inputOf(shapes::doubledSphere(2))).triangles.empty());
  CHECK(arranged(inputOf(shapes::turnedOver(shapes::icosphere(2)))).triangles.empty());
}

TEST_CASE("arrangement: all that goes is hidden, unless it is inside out or cancels") {
  const TriangleMesh ball = shapes::icosphere(2);
  const auto beside = [&](double by) {
    TriangleMesh other = ball;
    for (Vec3& p : other.positions) p = 0.7 * p + Vec3(by, 0.1, 0.2);
    return other;
  };
  CHECK_FALSE(arranged(inputOf(std::vector{ball, beside(0.9)})).isOutsideDropped);
  CHECK_FALSE(arranged(inputOf(std::vector{ball, beside(0.1)})).isOutsideDropped);
  CHECK(arranged(inputOf(std::vector{ball, shapes::turnedOver(beside(0.9))})).isOutsideDropped);
  CHECK(arranged(inputOf(std::vector{ball, shapes::turnedOver(ball)})).isOutsideDropped);
}

TEST_CASE("arrangement: a tube that crosses itself becomes its outside") {
  for (const int m : {6, 9, 16}) {
    const TriangleMesh tube = figureOfEight(41, m);
    const ArrangementInput input = inputOf(tube);
    const ArrangementResult result = arranged(input);
    const ArrangementResult twice =
        arranged(input, [](std::span<const int> w) { return w[0] > 1; });
    CHECK(twice.triangles.size() > 0);
    CHECK(volumeOf(result) + volumeOf(twice) == doctest::Approx(volumeOf(tube)));
    arranged(input, isWound, true);
  }
}

TEST_CASE("arrangement: triangles that intersect around their corner do not touch there") {
  for (const bool isSingle : {false, true}) {
    ArrangementInput body = inputOf(shapes::icosphere(8));
    soups::Random random(5);
    for (Vec3& p : body.positions) {
      const Vec3 by = random.point();
      p += 0.2 * (by - Vec3::Constant(0.5));
      if (isSingle) p = inSingle(p, {});
    }
    ArrangementOptions options;
    options.isSingle = isSingle;
    const ArrangementResult result = arrange(body, options);
    REQUIRE(result.outcome == Outcome::Done);
    CHECK(result.cut > 20);
    CHECK(isClosed(result));
    TriangleMesh outside = meshOf(result);
    CHECK(selfIntersections(outside).empty());
    keepUsedVertices(outside);
    CHECK(buildMesh(outside).mesh.vertexCount() == countPlaces(outside.positions));
  }
}

TEST_CASE("arrangement: a ring that reaches beyond its axis, where all its edges nearly meet") {
  TriangleMesh ring;
  constexpr int kAround = 24, kTube = 12;
  shapes::addSheet(ring, kAround, kTube, [&](int i, int k) {
    const double turn = 2 * std::numbers::pi * ((i % kAround) + 0.3) / kAround;
    const Vec3 tube = 1.2 * shapes::onCircle(k, kTube);
    const double radius = 1 + tube.x();
    return inSingle(Vec3(radius * std::cos(turn), radius * std::sin(turn), tube.y()), {});
  });
  if (shapes::volumeOf(ring) < 0) ring = shapes::turnedOver(ring);
  ArrangementOptions options;
  options.isSingle = true;
  const ArrangementResult result = arrange(inputOf(ring), options);
  CHECK(isClosed(result));
  CHECK(result.selfIntersections.empty());
  CHECK(result.triangles.size() < 2 * ring.triangleCount());
}

TEST_CASE("arrangement: random bodies; the volumes of the union and of the shared part add up") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    soups::Random random(seed);
    for (int k = 0; k < 8; ++k) random.number();
    const std::vector<TriangleMesh> shapes = {shapes::icosphere(3), soups::cube(-0.7, 0.8),
                                              shapes::torus(9, 5), shapes::cylinder(7, 2)};
    const TriangleMesh a = anywhere(shapes[seed % 4], random);
    const TriangleMesh b = anywhere(shapes[(seed / 4) % 4], random);
    const ArrangementInput input = inputOf({a, b}, true);
    const double sum = volumeOf(a) + volumeOf(b);
    for (const bool isSingle : {false, true}) {
      const double error = isSingle ? 1e-5 : 1e-12;
      const double either = volumeOf(arranged(input, inEither, isSingle));
      const double both = volumeOf(arranged(input, inBoth, isSingle));
      const double first = volumeOf(arranged(input, inFirstOnly, isSingle));
      CHECK(both > 0);
      CHECK(either + both == doctest::Approx(sum).epsilon(error));
      CHECK(first + both == doctest::Approx(volumeOf(a)).epsilon(error));
    }
  }
}

TEST_CASE("arrangement: many bodies at once, in any order of the triangles") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    INFO("seed " << seed);
    soups::Random random(seed);
    std::vector<TriangleMesh> bodies;
    for (int k = 0; k < 6; ++k) bodies.push_back(anywhere(shapes::icosphere(2), random));
    // These lie in common planes.
    for (int k = 0; k < 3; ++k) bodies.push_back(box({0.25 * k, 0, 0}, {0.25 * k + 0.5, 1, 0.5}));
    const ArrangementInput input = inputOf(bodies);
    const ArrangementResult result = arranged(input);
    CHECK(result.dropped > 0);

    std::vector<std::size_t> order(input.operands.size());
    for (std::size_t t = 0; t < order.size(); ++t) order[t] = (t * 7919 + seed) % order.size();
    REQUIRE(std::set(order.begin(), order.end()).size() == order.size());
    ArrangementInput other = input;
    for (std::size_t t = 0; t < order.size(); ++t)
      std::copy_n(input.indices.begin() + std::ptrdiff_t(3 * order[t]), 3,
                  other.indices.begin() + std::ptrdiff_t(3 * t));
    const ArrangementResult again = arranged(other);
    CHECK(trianglesOf(result.positions, result.indices) ==
          trianglesOf(again.positions, again.indices));
  }
}

TEST_CASE("arrangement: bodies that nearly coincide, in single precision") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    INFO("seed " << seed);
    soups::Random random(seed);
    std::vector<TriangleMesh> bodies;
    for (int k = 0; k < 3; ++k) {
      bodies.push_back(soups::moved(shapes::cylinder(9, 2), 1e-7 * random.point()));
      for (Vec3& p : bodies.back().positions) p = inSingle(p, {});
    }
    const ArrangementInput input = inputOf(bodies);
    ArrangementOptions options;
    options.isSingle = true;
    const ArrangementResult result = arrange(input, options);
    CHECK(isClosed(result));
    CHECK(volumeOf(result) == doctest::Approx(volumeOf(bodies[0])).epsilon(1e-5));
    // What is left is said, and what is known not to meet is known rightly.
    CHECK(selfIntersections(meshOf(result)) == result.selfIntersections);
    for (std::size_t v = input.positions.size(); v < result.positions.size(); ++v)
      REQUIRE(inSingle(result.positions[v], {}) == result.positions[v]);
  }
}

TEST_CASE("arrangement: where steps of coordinates are nearly as long as edges, none is lost") {
  std::vector<TriangleMesh> bodies;
  for (const double shift : {0.0, 0.6}) {
    bodies.push_back(soups::moved(shapes::icosphere(4), Vec3(0x1p20 + shift, shift / 2, 0)));
    for (Vec3& p : bodies.back().positions) p = inSingle(p, {});
  }
  const ArrangementInput input = inputOf(bodies);
  ArrangementOptions options;
  options.isSingle = true;
  const ArrangementResult result = arrange(input, options);
  REQUIRE(result.outcome == Outcome::Done);
  CHECK(isClosed(result));
  CHECK(volumeOf(result) > volumeOf(bodies[0]));
}

TEST_CASE("arrangement: untouched triangles stay, in their order") {
  const TriangleMesh sphere = shapes::icosphere(8);
  const ArrangementInput input = inputOf({sphere, soups::moved(sphere, Vec3(1.7, 0.1, 0.2))});
  const ArrangementResult result = arranged(input);
  std::size_t whole = 0;
  Index last = 0;
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    const Index parent = result.triangles[t].parent;
    CHECK(parent >= last);
    last = parent;
    whole += std::equal(result.indices.begin() + std::ptrdiff_t(3 * t),
                        result.indices.begin() + std::ptrdiff_t(3 * t + 3),
                        input.indices.begin() + std::ptrdiff_t(3 * parent));
  }
  CHECK(whole + result.cut + result.dropped >= input.operands.size());
  CHECK(whole > input.operands.size() / 2);
}

TEST_CASE("arrangement: facets of different classes are not merged") {
  ArrangementInput input = inputOf({box({0, 0, 0}, {4, 4, 4}), box({1, 0.5, 4}, {3, 2, 6})});
  const std::size_t merged = arranged(input).triangles.size();
  for (Index t = 0; t < input.operands.size(); ++t) input.classes.push_back(t);
  const ArrangementResult apart = arranged(input);
  CHECK(apart.triangles.size() > merged);
  for (const ArrangedTriangle& t : apart.triangles)
    for (const Vec3& w : t.weights) CHECK(w.minCoeff() >= 0);
}

TEST_CASE("arrangement: an open surface is refused, and so is too much work") {
  CHECK(arrange(inputOf(shapes::grid(3, 3)), {}).outcome == Outcome::NotClosed);
  ArrangementInput input = inputOf(soups::cube(0, 1));
  input.operands[3] = 1;
  CHECK(arrange(input, {}).outcome == Outcome::NotClosed);
  ArrangementOptions little;
  little.mostWork = 50;
  CHECK(arrange(inputOf(figureOfEight(41, 9)), little).outcome == Outcome::GaveUp);
  CHECK(arrange({}, {}).outcome == Outcome::Done);
}

TEST_CASE("arrangement: the size of the coordinates does not matter") {
  const TriangleMesh both = soups::joined({soups::cube(0, 1), soups::cube(0.25, 1.5)});
  const ArrangementResult result = arranged(inputOf(both));
  for (const double size : {0x1p-200, 0x1p200}) {
    const ArrangementResult other = arrange(inputOf(shapes::scaled(both, size)), {});
    CHECK(other.selfIntersections.empty());
    CHECK(other.indices == result.indices);
    for (std::size_t v = 0; v < result.positions.size(); ++v)
      REQUIRE(other.positions[v] == size * result.positions[v]);
  }
}

TEST_CASE("arrangement: plates on each other, turned and rounded, seldom keep an intersection") {
  // In other axes the plates' common planes are apart by roundings, so that their parts lie on each
  // other as near as numbers tell.
  constexpr int kTrials = 30;
  soups::Random random(11);
  int crossed = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    TriangleMesh plates;
    for (int i = 0; i < 3; ++i) {
      const Vec3 low = (6 * random.point()).array().round() / 4, size(1.5, 1, 0.5 + 0.25 * (i % 3));
      const Vec3 onGround(low.x(), low.y(), i % 2 == 0 ? 0 : 0.5);
      plates = soups::joined({plates, box(onGround, onGround + size)});
    }
    const ArrangementInput input = inputOf(anywhere(plates, random));
    const ArrangementResult turned = arrange(input, {isWound, true});
    REQUIRE(turned.outcome == Outcome::Done);
    CHECK(isClosed(turned));
    CHECK(volumeOf(turned) == doctest::Approx(volumeOf(arranged(inputOf(plates)))).epsilon(1e-5));
    crossed += turned.selfIntersections.empty() ? 0 : 1;
  }
  CHECK(crossed <= kTrials / 5);
}
