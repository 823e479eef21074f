// SPDX-License-Identifier: MIT
#include "remesh/schemes/follow.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "geometry/mesh_triangle.h"
#include "geometry/triangle.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "mesh/mesh_builder.h"
#include "mesh/welding.h"
#include "remesh/schemes/remesh.h"
#include "support/parts.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

// A pleated sheet whose pleats are narrower than an even triangle of 150 vertices.
TriangleMesh pleats(int rows = 32) {
  TriangleMesh mesh = shapes::grid(40, rows);
  for (Vec3& p : mesh.positions) {
    const bool isHigh = std::lround(p.x()) % 2 != 0;
    p = {p.x() / 2, 4 * p.y() / rows, isHigh ? 0.1 : 0.0};
  }
  return mesh;
}

// A prism of so many sides whose ends are fans of long triangles.
TriangleMesh coin(Index sides) {
  constexpr double kTurn = 6.283185307179586;
  TriangleMesh mesh;
  for (const double z : {0.0, 0.3})
    for (Index i = 0; i < sides; ++i)
      mesh.positions.emplace_back(std::cos(kTurn * i / sides), std::sin(kTurn * i / sides), z);
  for (Index i = 0; i < sides; ++i) {
    const Index next = (i + 1) % sides;
    mesh.indices.insert(mesh.indices.end(), {i, next, next + sides, i, next + sides, i + sides});
  }
  for (Index i = 1; i + 1 < sides; ++i)
    mesh.indices.insert(mesh.indices.end(), {0, i + 1, i, sides, sides + i, sides + i + 1});
  return mesh;
}

TriangleMesh remeshed(const TriangleMesh& input, Index vertices, Textures textures) {
  PartOptions options;
  options.vertices = vertices;
  options.textures = textures;
  if (textures == Textures::Keep) options.prefer = Prefer::Even;
  return remeshSurface(input, options, {}).mesh;
}

// How much of an arm's skin moves with the joint at 24.
double shareOfElbow(double z) { return std::clamp((z - 16) / 16, 0.0, 1.0); }

// A tube of flat facets with a skin, whose second joint takes over halfway. With a chart, whose
// seam runs along it, its width varies.
TriangleMesh arm(bool hasChart) {
  constexpr int kSides = 16, kRows = 48;
  constexpr double kTurn = 6.283185307179586;
  TriangleMesh mesh = shapes::grid(kSides, kRows);
  Attribute uv{"TEXCOORD_0", 2, {}}, joints{"JOINTS_0", 4, {}}, weights{"WEIGHTS_0", 4, {}};
  for (Vec3& p : mesh.positions) {
    const double angle = kTurn * std::fmod(p.x(), kSides) / kSides, z = p.y();
    const double elbow = shareOfElbow(z), width = hasChart ? 4 + std::cos(z / 4) : 4;
    uv.values.insert(uv.values.end(), {float(p.x() / kSides), float(z / kRows)});
    joints.values.insert(joints.values.end(), {3, 5, 0, 0});
    weights.values.insert(weights.values.end(), {float(1 - elbow), float(elbow), 0, 0});
    p = {width * std::cos(angle), width * std::sin(angle), z};
  }
  mesh.attributes = {joints, weights};
  if (hasChart) mesh.attributes.insert(mesh.attributes.begin(), uv);
  return mesh;
}

// The arm with its elbow bent by a quarter turn.
TriangleMesh bent(TriangleMesh mesh) {
  const std::vector<float>& weights = findAttribute(mesh, "WEIGHTS_0")->values;
  const std::vector<float>& joints = findAttribute(mesh, "JOINTS_0")->values;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    double elbow = 0;
    for (std::size_t k = 4 * v; k < 4 * v + 4; ++k) elbow += joints[k] == 5 ? weights[k] : 0;
    const Vec3 p = mesh.positions[v], turned(p.z() - 24, p.y(), 24 - p.x());
    mesh.positions[v] = (1 - elbow) * p + elbow * turned;
  }
  return mesh;
}

TriangleMesh ballOfCells() {
  return shapes::cells(11, [](int x, int y, int z) {
    return (Vec3(x, y, z) - Vec3::Constant(5)).squaredNorm() < 30;
  });
}

// Each cell has a colour of its own.
TriangleMesh painted(const TriangleMesh& plain) {
  TriangleMesh mesh;
  mesh.attributes = {{"COLOR_0", 3, {}}};
  for (std::size_t t = 0; t < plain.triangleCount(); ++t) {
    const auto [a, b, c] = cornersOf(plain, t);
    const Vec3 within = (a + b + c) / 3 - unitNormal(a, b, c) / 2;
    for (const Vec3& p : {a, b, c}) {
      mesh.indices.push_back(Index(mesh.positions.size()));
      mesh.positions.push_back(p);
      for (int k = 0; k < 3; ++k)
        mesh.attributes[0].values.push_back(float(std::floor(within[k])) / 10);
    }
  }
  return mesh;
}

double rms(const TriangleMesh& original, const TriangleMesh& result) {
  const DeviationBothWays d = measureDeviation(original, result, Maximum::Sampled);
  return std::max(d.toResult.rms, d.toOriginal.rms) / d.diagonal;
}

}  // namespace

TEST_CASE("follow: exactly as many places as asked for, or nothing") {
  const TriangleMesh input = pleats();
  const BuiltMesh built = buildMesh(input);
  for (const std::size_t count : {1000, 500, 150}) {
    const std::optional<Followed> followed = follow(built, input, count, {Textures::Bake});
    REQUIRE(followed);
    CHECK(inspectMesh(followed->mesh).vertices == count);
    CHECK(followed->places.size() == followed->mesh.indices.size());
  }
  CHECK(!isWorthFollowing(built, 4));
  // Nothing is left out of what has just so many, and nothing is made of fewer.
  const std::optional<Followed> whole =
      follow(built, input, built.mesh.vertexCount(), {Textures::Keep});
  REQUIRE(whole);
  CHECK(whole->away.rms < 1e-12);
  CHECK(!follow(built, input, built.mesh.vertexCount(), {Textures::Bake}));
  CHECK(!follow(built, input, built.mesh.vertexCount() + 1, {Textures::Bake}));
  CHECK(follow(built, input, built.mesh.vertexCount(), {Textures::Bake, true}));
}

TEST_CASE("follow: its costs ascend, one for each place that it can take, and the rest is left") {
  const TriangleMesh input = pleats();
  const BuiltMesh built = buildMesh(input);
  const std::vector<double> costs = followCosts(built, input, Textures::Bake);
  CHECK(std::is_sorted(costs.begin(), costs.end()));
  const std::size_t left = built.mesh.vertexCount() - costs.size();
  CHECK(left >= 3);
  CHECK(!follow(built, input, 1, {Textures::Bake}));
  const std::optional<Followed> fewest =
      follow(built, input, 1, {Textures::Bake, false, TooFew::Raise});
  REQUIRE(fewest);
  CHECK(fewest->positions == inspectMesh(fewest->mesh).vertices);
  CHECK(fewest->positions <= left);
}

TEST_CASE("follow: where attributes are kept, vertices are the original's, and so are theirs") {
  TriangleMesh input = shapes::icosphere(12);
  Attribute uv{"TEXCOORD_0", 2, {}};
  for (const Vec3& p : input.positions)
    uv.values.insert(uv.values.end(), {float(p.x()), float(p.y())});
  input.attributes.push_back(uv);
  const std::optional<Followed> followed = follow(buildMesh(input), input, 200, {Textures::Keep});
  REQUIRE(followed);
  const TriangleMesh& result = followed->mesh;
  CHECK(inspectMesh(result).vertices == 200);
  for (std::size_t v = 0; v < result.positions.size(); ++v) {
    const Vec3& p = result.positions[v];
    CHECK(std::find(input.positions.begin(), input.positions.end(), p) != input.positions.end());
    CHECK(result.attributes[0].values[2 * v] == float(p.x()));
    CHECK(result.attributes[0].values[2 * v + 1] == float(p.y()));
  }
}

TEST_CASE("follow: fewer vertices than places where seams meet, and no triangle leaves its chart") {
  // Tiles of two by two cells, each a chart of its own, ten to the right of the one before.
  const TriangleMesh sheet = shapes::grid(24, 24);
  TriangleMesh input;
  Attribute uv{"TEXCOORD_0", 2, {}};
  for (Index t = 0; t < sheet.triangleCount(); ++t) {
    Vec3 middle = Vec3::Zero();
    for (Index k = 0; k < 3; ++k) middle += sheet.positions[sheet.indices[3 * t + k]] / 3;
    const double chart = 12 * std::floor(middle.y() / 2) + std::floor(middle.x() / 2);
    for (Index k = 0; k < 3; ++k) {
      const Vec3& p = sheet.positions[sheet.indices[3 * t + k]];
      input.indices.push_back(Index(input.positions.size()));
      input.positions.push_back(p);
      uv.values.insert(uv.values.end(), {float(10 * chart + p.x() / 24), float(p.y() / 24)});
    }
  }
  input.attributes.push_back(uv);
  const std::optional<Followed> followed = follow(buildMesh(input), input, 100, {Textures::Keep});
  REQUIRE(followed);
  const TriangleMesh& result = followed->mesh;
  CHECK(inspectMesh(result).vertices == 100);
  for (Index t = 0; t < result.triangleCount(); ++t) {
    const auto chartAt = [&](Index k) {
      return std::floor(result.attributes[0].values[2 * result.indices[3 * t + k]] / 10);
    };
    CHECK(chartAt(0) == chartAt(1));
    CHECK(chartAt(0) == chartAt(2));
  }
  // Where seams end on the boundary, it stays where it was.
  const Welding welding(result);
  welding.forEachEdge([&](std::span<const Index> edge) {
    if (edge.size() != 1) return;
    const Vec3& p = result.positions[welding.corners[edge[0]]];
    CHECK(std::min({p.x(), p.y(), 24 - p.x(), 24 - p.y()}) == 0);
  });
}

TEST_CASE("follow: every triangle keeps its group, and corners know a place of that near them") {
  TriangleMesh input = shapes::grid(24, 24);
  Attribute places{"_PLACE", 3, {}};
  for (const Vec3& p : input.positions)
    places.values.insert(places.values.end(), {float(p.x()), float(p.y()), float(p.z())});
  input.attributes.push_back(places);
  for (Index t = 0; t < input.triangleCount(); ++t)
    input.groups.push_back(input.positions[input.indices[3 * t]].x() < 11.5 ? 0 : 1);
  const std::optional<Followed> followed = follow(buildMesh(input), input, 60, {Textures::Bake});
  REQUIRE(followed);
  CHECK(inspectMesh(followed->mesh).vertices == 60);
  CHECK(followed->mesh.groups.size() == followed->mesh.triangleCount());
  for (std::size_t h = 0; h < followed->places.size(); ++h) {
    const InputPlace& place = followed->places[h];
    CHECK(input.groups[place.triangle.index] == followed->mesh.groups[h / 3]);
    CHECK(place.weights.sum() == 1);
    const Index v = followed->mesh.indices[h];
    const float* const value = &followed->mesh.attributes[0].values[3 * std::size_t{v}];
    const Vec3 from(value[0], value[1], value[2]);
    CHECK((followed->mesh.positions[v] - from).norm() < 12);
  }
}

TEST_CASE("follow: where a vertex moves, attributes are those of the original at its new place") {
  const TriangleMesh input = arm(true);
  const std::optional<Followed> followed = follow(buildMesh(input), input, 90, {Textures::Bake});
  REQUIRE(followed);
  const TriangleMesh& result = followed->mesh;
  std::size_t moved = 0;
  for (std::size_t v = 0; v < result.positions.size(); ++v) {
    const Vec3& p = result.positions[v];
    moved += std::count(input.positions.begin(), input.positions.end(), p) == 0 ? 1 : 0;
    double fifth = 0;
    for (std::size_t k = 4 * v; k < 4 * v + 4; ++k)
      if (result.attributes[1].values[k] == 5) fifth += result.attributes[2].values[k];
    CHECK(fifth == doctest::Approx(shareOfElbow(p.z())).epsilon(0.03));
  }
  CHECK(moved > result.positions.size() / 3);
  for (std::size_t t = 0; t < result.triangleCount(); ++t) {
    const auto u = [&](std::size_t k) {
      return result.attributes[0].values[2 * std::size_t{result.indices[3 * t + k]}];
    };
    CHECK(std::max({u(0), u(1), u(2)}) - std::min({u(0), u(1), u(2)}) < 0.5F);
  }
}

TEST_CASE("follow: an elbow keeps the vertices that it needs when it is bent") {
  const TriangleMesh input = arm(false);
  const std::optional<Followed> followed = follow(buildMesh(input), input, 120, {Textures::Keep});
  REQUIRE(followed);
  // Nothing else needs vertices there: without a say, the skin is 0.0085 away.
  CHECK(rms(bent(input), bent(followed->mesh)) < 0.004);
}

TEST_CASE("follow: fewer vertices than curves have corners, where textures are baked") {
  const TriangleMesh cubes =
      shapes::cells(5, [](int i, int j, int k) { return i % 2 == 0 && j % 2 == 0 && k % 2 == 0; });
  CHECK_THROWS(remeshed(cubes, 150, Textures::Keep));
  CHECK(inspectMesh(remeshed(cubes, 150, Textures::Bake)).vertices == 150);
}

TEST_CASE("follow: pleats narrower than isotropic triangles are kept where textures are baked") {
  for (const int rows : {32, 112}) {
    CAPTURE(rows);
    const TriangleMesh original = pleats(rows);
    const double even = rms(original, remeshed(original, 150, Textures::Keep));
    const double followed = rms(original, remeshed(original, 150, Textures::Bake));
    CHECK(even > 0.001);
    CHECK(followed < 0.1 * even);
  }
}

TEST_CASE("follow: what isotropic triangles show has isotropic triangles") {
  for (const TriangleMesh& original : {shapes::icosphere(16), shapes::torus(64, 32)}) {
    double mean = 0;
    // By the seed of annealing one number gives 53.4° to 56.8°, three together 54.0° to 56.1°.
    for (const Index vertices : {700u, 750u, 800u})
      mean += inspectMesh(remeshed(original, vertices, Textures::Bake)).minAngle.mean / 3;
    CHECK(mean > 52);
  }
}

TEST_CASE("follow: taken for pleats that isotropic triangles lose, not for what is round") {
  const auto preferred = [](const TriangleMesh& input, double share, Prefer prefer) {
    PartOptions options;
    options.ratio = share;
    options.prefer = prefer;
    options.detectFeatures = false;
    return remeshSurface(input, options, {}).prefer;
  };
  TriangleMesh high = pleats();
  for (Vec3& p : high.positions) p.z() *= 4;
  CHECK(preferred(high, 0.12, Prefer::Auto) == Prefer::Shape);
  CHECK(preferred(high, 0.12, Prefer::Even) == Prefer::Even);
  CHECK(preferred(shapes::icosphere(12), 1, Prefer::Auto) == Prefer::Even);
  CHECK(preferred(shapes::icosphere(12), 0.25, Prefer::Auto) == Prefer::Even);
  CHECK(preferred(shapes::icosphere(12), 0.25, Prefer::Shape) == Prefer::Shape);
}

TEST_CASE("follow: more vertices than its own take a body of flat sides no farther away") {
  for (const TriangleMesh& input : {coin(64), shapes::filletedBar(6)}) {
    const double own = double(inspectMesh(input).vertices);
    for (const double times : {1.0, 1.02, 1.1, 1.3, 2.0, 4.0}) {
      CAPTURE(times);
      PartOptions options;
      options.vertices = Index(std::lround(times * own));
      const RemeshOutcome outcome = remeshSurface(input, options, {});
      CHECK(inspectMesh(outcome.mesh).vertices == *options.vertices);
      const DeviationBothWays d = measureDeviation(input, outcome.mesh, Maximum::Sampled);
      CHECK(std::max(d.toResult.maximum, d.toOriginal.maximum) <= 5.1e-4 * d.diagonal);
    }
  }
}

TEST_CASE("follow: the places of a divided mesh are its own, or none") {
  TriangleMesh input = coin(64);
  input.attributes = {{"TEXCOORD_0", 2, {}}};
  for (const Vec3& p : input.positions)
    for (int k = 0; k < 2; ++k) input.attributes[0].values.push_back(float(p[k]));
  for (const double times : {1.05, 1.3, 2.0, 3.9}) {
    CAPTURE(times);
    PartOptions options;
    options.vertices = Index(std::lround(times * double(inspectMesh(input).vertices)));
    const RemeshOutcome outcome = remeshSurface(input, options, {});
    CHECK((outcome.places.empty() || outcome.places.size() == outcome.mesh.indices.size()));
    for (const InputPlace& place : outcome.places)
      CHECK(place.triangle.index < input.triangleCount());
  }
}

TEST_CASE("follow: with about its own number of vertices a body of flat sides stays itself") {
  const TriangleMesh input = coin(64);
  for (const Index vertices : {128u, 129u}) {
    CAPTURE(vertices);
    PartOptions options;
    options.vertices = vertices;
    const RemeshOutcome outcome = remeshSurface(input, options, {});
    CHECK(outcome.prefer == Prefer::Shape);
    CHECK(inspectMesh(outcome.mesh).vertices == vertices);
    const DeviationBothWays d = measureDeviation(input, outcome.mesh, Maximum::Sampled);
    CHECK(std::max(d.toResult.maximum, d.toOriginal.maximum) < 1e-9 * d.diagonal);
  }
}

TEST_CASE("follow: a colour on each cell of a body does not cost its shape") {
  const TriangleMesh plain = ballOfCells(), coloured = painted(plain);
  const std::size_t own = inspectMesh(plain).vertices;
  const auto away = [&](const TriangleMesh& input) {
    return follow(buildMesh(input), input, own / 2, {Textures::Keep}).value().away;
  };
  CHECK(away(coloured).farthest < 1.1 * away(plain).farthest);
  // Nor is a number raised that has no room for the corners of all cells.
  PartOptions options;
  options.vertices = Index(own / 3);
  options.tooFew = TooFew::Raise;
  CHECK(remeshSurface(coloured, options, {}).vertices == own / 3);
}

TEST_CASE("follow: a texture that is drawn unevenly hardly costs the shape") {
  TriangleMesh sheet = shapes::grid(40, 40);
  Attribute even{"TEXCOORD_0", 2, {}}, uneven = even;
  for (Vec3& p : sheet.positions) {
    const double u = p.x() / 40, v = p.y() / 40;
    p = {u, v, 0.1 * std::sin(9 * u) * std::cos(7 * v)};
    even.values.insert(even.values.end(), {float(u), float(v)});
    uneven.values.insert(uneven.values.end(), {float(u * u * u), float(v * v)});
  }
  const auto away = [&](const Attribute& texcoords) {
    TriangleMesh input = sheet;
    input.attributes = {texcoords};
    return follow(buildMesh(input), input, 300, {Textures::Keep}).value().away;
  };
  CHECK(away(uneven).rms < 1.15 * away(even).rms);
}
