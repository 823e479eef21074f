// SPDX-License-Identifier: MIT
#include "remesh/conforming/conforming.h"

#include <cmath>
#include <utility>
#include <vector>

#include "base/options.h"
#include "base/place.h"
#include "geometry/triangle.h"
#include "remesh/conforming/exchange.h"
#include "remesh/conforming/refinement.h"
#include "remesh/conforming/smoothing_facets.h"
#include "remesh/conforming/thinning.h"

namespace remesher {

namespace {

// Facets that bend by less against each other are parts of one smooth surface.
const double kCosineOfSmooth = std::cos(radians(30));

std::size_t placesOf(const FacetedMesh& mesh) {
  std::vector<Vec3> places;
  for (Index i = 0; i < mesh.mesh().vertexCapacity(); ++i)
    if (mesh.mesh().isAlive(Vertex(i))) places.push_back(mesh.positions()[Vertex(i)]);
  return countPlaces(places);
}

// Whether no edge through unrolled facets is farther from them than it may be.
bool isNear(const FacetedMesh& mesh) {
  const HalfedgeMesh& m = mesh.mesh();
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!m.isEdge(h) || mesh.isLine(h)) continue;
    if (mesh.isDeep(m.origin(h), m.tip(h), mesh.facet(m.face(h)))) return false;
  }
  return true;
}

// Whether the vertex lies in an unrolled facet, or on a smooth line between two of them.
bool isLiftable(const FacetedMesh& mesh, Vertex v) {
  if (mesh.role(v) == FacetRole::Corner) return false;
  const HalfedgeMesh& m = mesh.mesh();
  const auto normalOf = [&](Halfedge h) {
    const auto [a, b, c] = m.vertices(m.face(h));
    return unitNormal(mesh.positions()[a], mesh.positions()[b], mesh.positions()[c]);
  };
  bool may = true;
  m.forEachOutgoing(v, [&](Halfedge h) {
    may = may && mesh.isBent(mesh.facet(m.face(h)));
    if (!may || !mesh.isLine(h)) return;
    const Halfedge t = m.twin(h);
    may = t && !mesh.isKept(h) && normalOf(h).dot(normalOf(t)) > kCosineOfSmooth;
  });
  return may;
}

// Edges through unrolled facets are chords: all on one side of the original. Vertices inside move
// to the other side by as much as the chords are away on average, so that the volume stays and the
// largest distance becomes smaller.
void balance(FacetedMesh& mesh) {
  const HalfedgeMesh& m = mesh.mesh();
  std::vector<std::pair<Vertex, Vec3>> ways;
  for (Index i = 0; i < m.vertexCapacity(); ++i) {
    const Vertex v(i);
    if (!m.isAlive(v) || !isLiftable(mesh, v)) continue;
    Vec3 sum = Vec3::Zero();
    int chords = 0;
    m.forEachOutgoing(v, [&](Halfedge h) {
      const Vertex w = m.tip(h);
      const Vec3 gap = mesh.halfway(v, w, mesh.facet(m.face(h))) -
                       0.5 * (mesh.positions()[v] + mesh.positions()[w]);
      // Where a facet ends between the two, the way between them is another.
      if (gap.norm() <= mesh.depth()) sum += gap;
      ++chords;
    });
    ways.emplace_back(v, sum / chords);
  }
  for (const auto& [v, way] : ways) mesh.lift(v, way);
}

}  // namespace

std::unique_ptr<FacetedMesh> makeConforming(const BuiltMesh& original,
                                            const HalfedgeData<char>& seams, std::size_t positions,
                                            const FacetLimits& limits) {
  auto mesh = std::make_unique<FacetedMesh>(original, seams, limits);
  if (mesh->hasOpenSeam() || (limits.depth > 0 && !mesh->hasBent())) return nullptr;
  thinOut(*mesh);
  // Vertices of sheets that coincide may come to lie in one place.
  constexpr int kMostRounds = 4;
  for (int round = 0; round < kMostRounds; ++round) {
    const std::size_t now = placesOf(*mesh);
    if (now > positions || !refineFacets(*mesh, positions - now)) return nullptr;
    if (!mesh->isSound()) return nullptr;
    smoothFacets(*mesh);
    mesh = exchangeVertices(std::move(mesh));
    if (placesOf(*mesh) != positions) continue;
    if (!isNear(*mesh)) return nullptr;
    balance(*mesh);
    return mesh;
  }
  return nullptr;
}

std::size_t fewestConforming(const BuiltMesh& original, const HalfedgeData<char>& seams) {
  FacetedMesh mesh(original, seams, {});
  thinOut(mesh);
  return placesOf(mesh);
}

}  // namespace remesher
