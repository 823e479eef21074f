// SPDX-License-Identifier: MIT
// Where vertices are on the original, and in the planes of facets.
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/predicates.h"
#include "geometry/triangle.h"
#include "remesh/conforming/faceted_mesh.h"

namespace remesher {

namespace {

// A point this near to a corner or an edge of its triangle, in weights, is on it.
constexpr double kOnIt = 1e-12;

}  // namespace

// The same point in a triangle of the facet that has the same corner or edge, if any has.
std::optional<SurfacePoint> FacetedMesh::across(const SurfacePoint& point, Index facet) const {
  const HalfedgeMesh& m = original_.mesh;
  Eigen::Index largest = 0, least = 0;
  if (point.barycentric.maxCoeff(&largest) >= 1 - kOnIt) {
    std::optional<SurfacePoint> found;
    m.forEachOutgoing(m.vertices(point.face)[std::size_t(largest)], [&](Halfedge h) {
      if (!found && ownFacet_[m.face(h)] == facet)
        found = {m.face(h), Vec3::Unit(Eigen::Index(h.index % 3))};
    });
    return found;
  }
  if (point.barycentric.minCoeff(&least) > kOnIt) return {};
  const Halfedge h = HalfedgeMesh::halfedge(point.face, int((least + 1) % 3)), t = m.twin(h);
  if (!t || ownFacet_[m.face(t)] != facet) return {};
  SurfacePoint result{m.face(t), Vec3::Zero()};
  result.barycentric[Eigen::Index(t.index % 3)] = point.barycentric[(least + 2) % 3];
  result.barycentric[Eigen::Index(m.next(t).index % 3)] = point.barycentric[(least + 1) % 3];
  return result;
}

// Of a place without numbers, beside a triangle that is hardly more than a line, a corner.
SurfacePoint FacetedMesh::nearestIn(Index facet, const Vec3& place, bool isFlat) const {
  const auto corner = [&](Face f, int k) -> Vec3 {
    if (!isFlat) return original_.positions[original_.mesh.vertices(f)[std::size_t(k)]];
    const Vec2 p = ownFlat(f, k, facet);
    return {p.x(), p.y(), 0};
  };
  SurfacePoint best{faces_[facet].front(), Vec3::Unit(0)};
  double least = kInfinity;
  for (const Face f : faces_[facet]) {
    const Vec3 a = corner(f, 0), b = corner(f, 1), c = corner(f, 2);
    const Vec3 weights = closestBarycentric(place, a, b, c);
    const double squared = (weights[0] * a + weights[1] * b + weights[2] * c - place).squaredNorm();
    if (squared < least) least = squared, best = {f, weights};
  }
  return best;
}

Vec2 FacetedMesh::ownFlat(Face f, int corner, Index facet) const {
  if (isBent(facet)) return unrolled_.corners[f][std::size_t(corner)];
  return frames_[facet].flat(original_.positions[original_.mesh.vertices(f)[std::size_t(corner)]]);
}

Vec2 FacetedMesh::flatOf(const SurfacePoint& point, Index facet) const {
  const auto corner = [&](int k) { return ownFlat(point.face, k, facet); };
  return point.barycentric[0] * corner(0) + point.barycentric[1] * corner(1) +
         point.barycentric[2] * corner(2);
}

Vec2 FacetedMesh::unrolled(Vertex v, Index facet) const {
  FlatPlaces& known = known_[v];
  for (const FlatPlace& place : known)
    if (place.facet == facet) return place.at;
  known[1] = known[0];
  known[0] = {facet, flatOf(pointIn(v, facet), facet)};
  return known[0].at;
}

// Of the place in the triangle, or of the nearest place that is in it.
Vec3 FacetedMesh::weightsIn(Face f, const Vec2& place, Index facet) const {
  const auto at = [&](const Vec2& p) { return Vec3(p.x(), p.y(), 0); };
  return closestBarycentric(at(place), at(ownFlat(f, 0, facet)), at(ownFlat(f, 1, facet)),
                            at(ownFlat(f, 2, facet)));
}

bool FacetedMesh::hasBent() const {
  return std::find(unrolled_.isBent.begin(), unrolled_.isBent.end(), 1) != unrolled_.isBent.end();
}

Vec3 FacetedMesh::halfway(Vertex a, Vertex b, Index facet) const {
  const Face start = pointIn(a, facet).face;
  return placeAt(0.5 * (flat(a, facet) + flat(b, facet)), facet, start).position;
}

// A way of length L between two points is nowhere farther from their chord c than the ellipse about
// them whose long axis is L is wide.
bool FacetedMesh::isDeep(Vertex a, Vertex b, Index facet) const {
  if (!isBent(facet)) return false;
  const double way = (flat(b, facet) - flat(a, facet)).squaredNorm();
  const double chord = (positions_[b] - positions_[a]).squaredNorm();
  return way - chord > 4 * depth() * depth();
}

SurfacePoint FacetedMesh::pointIn(Vertex v, Index facet) const {
  if (ownFacet_[at_[v].face] == facet) return at_[v];
  const std::optional<SurfacePoint> found = across(at_[v], facet);
  return found ? *found : nearestIn(facet, positions_[v], false);
}

// Walks from triangle to triangle towards the place; where a walk ends at the rim of the facet, all
// triangles are looked at.
FacetedMesh::Place FacetedMesh::placeAt(const Vec2& place, Index facet, Face start) const {
  const HalfedgeMesh& m = original_.mesh;
  Face f = start, end = start;
  std::size_t steps = 0;
  for (; f && steps <= faces_[facet].size(); ++steps) {
    end = f;
    Halfedge out;
    for (std::size_t k = 0; k < 3 && !out; ++k) {
      const int from = int((k + steps) % 3), to = (from + 1) % 3;
      if (orient2d(ownFlat(f, from, facet), ownFlat(f, to, facet), place) < 0)
        out = HalfedgeMesh::halfedge(f, from);
    }
    if (!out) break;
    const Halfedge t = m.twin(out);
    f = t && ownFacet_[m.face(t)] == facet ? m.face(t) : Face();
  }
  const bool isInside = f && steps <= faces_[facet].size();
  const SurfacePoint found = isInside ? SurfacePoint{end, weightsIn(end, place, facet)}
                                      : nearestIn(facet, Vec3(place.x(), place.y(), 0), true);
  // By differences, so that a coordinate that all three corners have stays as it is.
  const auto [a, b, c] = m.vertices(found.face);
  const Vec3& first = original_.positions[a];
  return {found, first + found.barycentric[1] * (original_.positions[b] - first) +
                     found.barycentric[2] * (original_.positions[c] - first)};
}

}  // namespace remesher
