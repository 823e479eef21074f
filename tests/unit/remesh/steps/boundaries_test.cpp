// SPDX-License-Identifier: MIT
#include "remesh/steps/boundaries.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"
#include "mesh/mesh_builder.h"
#include "remesh/schemes/best.h"
#include "remesh/schemes/remesh.h"
#include "remesh/schemes/rounds.h"
#include "support/runs.h"

using namespace remesher;

namespace {

enum class Outline { Square, Round };

// A hilly sheet whose outline winds, to this share of its size.
TriangleMesh sheet(double winding, Outline outline = Outline::Square) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, 48, 48, [&](int i, int k) {
    const double u = i / 24.0 - 1, v = k / 24.0 - 1;
    const double reach = 1 + winding * std::sin(11 * u) * std::cos(13 * v);
    const bool round = outline == Outline::Round;
    const double x = round ? u * std::sqrt(1 - v * v / 2) : u;
    const double y = round ? v * std::sqrt(1 - u * u / 2) : v;
    return Vec3(reach * x, reach * y, 0.1 * std::sin(2 * u) * std::cos(3 * v));
  });
  return mesh;
}

// The farthest that a boundary vertex of the original lies from the chord that stands for it.
double farthestChord(const WorkingMesh& mesh) {
  double most = 0;
  const HalfedgeMesh& m = mesh.mesh();
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!m.isAlive(h) || !m.isBoundary(h)) continue;
    const Chain& chain = mesh.surface().curves().chains()[mesh.curve(h)];
    const double a = mesh.onChain(m.origin(h), mesh.curve(h)).arc;
    const double b = mesh.onChain(m.tip(h), mesh.curve(h)).arc;
    const Vec3 &from = mesh.position(m.origin(h)), &to = mesh.position(m.tip(h));
    for (std::size_t k = 0; k < chain.arcs.size(); ++k) {
      if (chain.arcs[k] < std::min(a, b) || chain.arcs[k] > std::max(a, b)) continue;
      const Vec3& p = mesh.surface().positions()[chain.vertices[k]];
      most = std::max(most, (closestPoint(p, from, to, to) - p).norm());
    }
  }
  return most;
}

struct Means {
  double beside = 0, inside = 0;
};

// Of the smallest angles, in degrees, of the triangles that touch a boundary and of the others.
Means meanAngles(const TriangleMesh& result) {
  const BuiltMesh built = buildMesh(result);
  Means sums, counts;
  for (Index i = 0; i < built.mesh.faceCapacity(); ++i) {
    const auto [a, b, c] = built.mesh.vertices(Face(i));
    const auto isOutside = [&](Vertex v) { return built.mesh.isBoundary(v); };
    const bool touches = isOutside(a) || isOutside(b) || isOutside(c);
    const double angle = minAngle(built.positions[a], built.positions[b], built.positions[c]);
    (touches ? sums.beside : sums.inside) += degrees(angle);
    (touches ? counts.beside : counts.inside) += 1;
  }
  return {sums.beside / counts.beside, sums.inside / counts.inside};
}

}  // namespace

TEST_CASE("boundaries: a resampled one stays within 0.1 % of the diagonal, in both schemes") {
  for (const double winding : {0.03, 0.1}) {
    const OriginalSurface surface = shapes::surfaceOf(sheet(winding));
    for (const double vertices : {600.0})
      for (const double adaptivity : {0.0, 0.5}) {
        CAPTURE(winding);
        CAPTURE(vertices);
        CAPTURE(adaptivity);
        SizeField sizes(surface, {.vertices = vertices, .adaptivity = adaptivity});
        Projector projector(surface, Projection::Patches, 2 * sizes.mean());
        WorkingMesh mesh(surface);
        Run run{mesh, projector, sizes, {}};
        CHECK((adaptivity > 0 ? runBest(run, {std::size_t(vertices), Quality::Best, nullptr}, {})
                              : runRounds(run, {std::size_t(vertices)}, {})));
        CHECK(farthestChord(mesh) < 1e-3 * surface.diagonal());
        CHECK(check(mesh.mesh()) == "");
      }
  }
}

TEST_CASE("boundaries: triangles there are as good as inside, within 2°") {
  PartOptions options;
  options.vertices = 2000;
  for (const Outline outline : {Outline::Square, Outline::Round})
    for (const double winding : {0.0, 0.01}) {
      CAPTURE(int(outline));
      CAPTURE(winding);
      const Means means = meanAngles(remeshSurface(sheet(winding, outline), options, {}).mesh);
      CHECK(means.beside > means.inside - 2);
    }
}
