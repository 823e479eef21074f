// SPDX-License-Identifier: MIT
#include "remesh/schemes/mirrored.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "geometry/triangle_tree.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

// A ball with a bump at positive x that the other side has only in part.
TriangleMesh lopsidedBall(double share) {
  TriangleMesh ball = shapes::icosphere(8);
  for (Vec3& p : ball.positions) {
    const Vec3 away = Vec3(std::abs(p.x()), p.y(), p.z()) - Vec3(0.8, 0.6, 0);
    p *= 1 + 0.2 * (p.x() > 0 ? 1 : share) * std::exp(-6 * away.squaredNorm());
  }
  return ball;
}

RemeshOutcome quadsOf(const TriangleMesh& mesh, Symmetry symmetry) {
  PartOptions options;
  options.quads = true;
  options.vertices = 400;
  options.symmetry = symmetry;
  return remeshSurface(mesh, options, {});
}

// Whether the places with this axis turned over are the same places; the plane is through 0.
bool isMirrored(const TriangleMesh& mesh, Eigen::Index axis) {
  using Place = std::tuple<double, double, double>;
  std::set<Place> places, images;
  for (Vec3 p : mesh.positions) {
    places.insert({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0});
    p[axis] = -p[axis];
    images.insert({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0});
  }
  return places == images;
}

const Warning* findWarning(const RemeshOutcome& made, const std::string& code) {
  const auto found = std::find_if(made.warnings.begin(), made.warnings.end(),
                                  [&](const Warning& one) { return one.code == code; });
  return found == made.warnings.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("mirrored: on request a lopsided model gets mirrored quads, from its larger side") {
  const TriangleMesh ball = lopsidedBall(0.9);
  const RemeshOutcome made = quadsOf(ball, Symmetry::X);
  REQUIRE(made.mirrors.size() == 1);
  const MirrorPlane& plane = made.mirrors[0];
  CHECK(made.mesh.triangleCount() > 600);
  CHECK(plane.normal.x() == 1);
  const Warning* said = findWarning(made, "QUADS_MADE_SYMMETRIC");
  REQUIRE(said);
  CHECK(said->message.find("larger x") != std::string::npos);
  TriangleMesh turned = ball;
  for (Vec3& p : turned.positions) p = Vec3(-p.x(), -p.y(), p.z());
  CHECK(quadsOf(turned, Symmetry::X).mirrors[0].normal.x() == -1);
}

TEST_CASE("mirrored: planes through the origin are exact, and several may be named") {
  const TriangleMesh ball = shapes::icosphere(8);
  const RemeshOutcome two = quadsOf(ball, Symmetry::XZ);
  CHECK(two.mirrors.size() == 2);
  CHECK(isMirrored(two.mesh, 0));
  CHECK(isMirrored(two.mesh, 2));
  CHECK(quadsOf(ball, Symmetry::XYZ).mirrors.size() == 3);
}

TEST_CASE("mirrored: a seam on one side only does not keep quads from being mirrored") {
  // A mirrored sheet with a seam along one row of edges of its right half.
  constexpr int kSize = 8;
  TriangleMesh sheet;
  shapes::addSheet(sheet, 2 * kSize, kSize, [&](int x, int y) {
    const double u = double(x - kSize) / kSize, v = double(y) / kSize;
    return Vec3(u, v, 0.2 * u * u + 0.1 * v * v * v);
  });
  TriangleMesh split;
  Attribute texture{"TEXCOORD_0", 2, {}};
  for (const Index v : sheet.indices) {
    const std::size_t t = split.indices.size() / 3;
    const Vec3& p = sheet.positions[v];
    double middle = 0;
    for (std::size_t k = 0; k < 3; ++k) middle += sheet.positions[sheet.indices[3 * t + k]].x() / 3;
    split.indices.push_back(Index(split.positions.size()));
    split.positions.push_back(p);
    texture.values.push_back(float(p.x() + (middle > 0.5 ? 5 : 0)));
    texture.values.push_back(float(p.y()));
  }
  split.attributes = {texture};
  const RemeshOutcome made = quadsOf(split, Symmetry::Auto);
  REQUIRE(made.mirrors.size() == 1);
  CHECK(isMirrored(made.mesh, 0));
  CHECK(!findWarning(made, "QUADS_SYMMETRY_LOST"));
  for (std::size_t v = 0; v < made.mesh.positions.size(); ++v) {
    const double x = made.mesh.positions[v].x(), u = made.mesh.attributes[0].values[2 * v];
    CHECK(std::min(std::abs(u - x), std::abs(u - x - 5)) < 0.02);
  }
}

TEST_CASE("mirrored: a symmetry that is given up is said, with its reason") {
  PartOptions options;
  options.quads = options.exact = true;
  options.vertices = 401;
  const RemeshOutcome odd = remeshSurface(shapes::icosphere(8), options, {});
  const Warning* said = findWarning(odd, "QUADS_SYMMETRY_LOST");
  REQUIRE(said);
  CHECK(said->message.find("exact") != std::string::npos);
  options.exact = false;
  options.density.assign(shapes::icosphere(8).positions.size(), 1);
  const RemeshOutcome graded = remeshSurface(shapes::icosphere(8), options, {});
  said = findWarning(graded, "QUADS_SYMMETRY_LOST");
  REQUIRE(said);
  CHECK(said->message.find("density") != std::string::npos);
}

TEST_CASE("mirrored: few quads keep the corners of a slab that fewer planes keep") {
  TriangleMesh slab = shapes::cube(2);
  for (Vec3& p : slab.positions) p = p.cwiseProduct(Vec3(4, 2, 0.5));
  PartOptions options;
  options.quads = true;
  for (const Index vertices : {56, 58}) {
    options.vertices = vertices;
    const RemeshOutcome made = remeshSurface(slab, options, {});
    const TriangleTree tree(made.mesh.positions, made.mesh.indices);
    for (const Vec3& p : slab.positions) CHECK(tree.nearest(p).squaredDistance < 1e-6);
  }
}
