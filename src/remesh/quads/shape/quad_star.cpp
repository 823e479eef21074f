// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/quad_star.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "original/surface/surface_walk.h"
#include "remesh/operators/smoothing.h"
#include "remesh/quads/shape/side_places.h"

namespace remesher {

namespace {

// Where curves end, a walk for a place beyond them ends too; and a vertex is there already.
bool isAtCorner(const SurfacePoint& p, const OriginalSurface& surface) {
  for (int i = 0; i < 3; ++i)
    if (p.barycentric[i] == 1)
      return surface.curves().isCorner(surface.mesh().origin(HalfedgeMesh::halfedge(p.face, i)));
  return false;
}

// Whether a quad between curves faces away from the surface on both sides of each of them.
bool facesAway(const QuadMesh& mesh, Index quad, const Vec3& normal) {
  constexpr double kAway = -0.7, kUpright = 0.1;
  double most = -1, least = 1;
  bool isBetweenCurves = false;
  for (const Index v : mesh.quads[quad]) {
    const Placement& place = mesh.vertices[v];
    if (place.kind != VertexKind::Curve) continue;
    isBetweenCurves = true;
    for (const Vec3& side : {place.normal, place.across}) {
      most = std::max(most, side.dot(normal));
      least = std::min(least, side.dot(normal));
    }
  }
  return isBetweenCurves && most < kUpright && least < kAway;
}

}  // namespace

Quad MovingQuads::corners(Index quad) const {
  const auto& [a, b, c, d] = mesh_.quads[quad];
  return {mesh_.position(a), mesh_.position(b), mesh_.position(c), mesh_.position(d)};
}

// Folds are seen along the original's normals. A vertex on a curve has several, so that only the
// normals of inner vertices count. A bent quad may look sound along these and yet be reflex, so
// that its own normal counts too.
double MovingQuads::qualityAlone(Index quad) const {
  const Quad places = corners(quad);
  const Quad across = cornerNormals(places);
  const Vec3 upward = areaVector(places).normalized();
  const double own = leastSine(across, upward);
  Vec3 normal = Vec3::Zero();
  for (const Index v : mesh_.quads[quad])
    if (mesh_.vertices[v].kind == VertexKind::Interior) normal += mesh_.vertices[v].normal;
  const double length = normal.norm();
  if (length > 0) return std::min(own, leastSine(across, normal / length));
  return own > 0 && facesAway(mesh_, quad, upward) ? -own : own;
}

double MovingQuads::quality(Index quad) const {
  const double alone = qualityAlone(quad);
  return alone > 0 && facing_ && facing_->isAway(corners(quad)) ? -alone : alone;
}

double MovingQuads::qualityAround(Index v) const {
  double worst = 1;
  sides_.forEachOutgoing(v, [&](Index side) { worst = std::min(worst, quality(side / 4)); });
  return worst;
}

// The place along the line between the two neighbours on the curve, from the arc of one to the arc
// of the other.
std::optional<Placement> MovingQuads::alongCurve(Index v, const Vec3& p) const {
  const Placement& here = mesh_.vertices[v];
  std::vector<Index> neighbors;
  sides_.forEachOutgoing(v, [&](Index side) {
    const Index before = prevSide(side);
    if (mesh_.curves[side / 4][side % 4] == here.on.chain) neighbors.push_back(sides_.tip(side));
    if (sides_.across(before) == kNone && mesh_.curves[before / 4][before % 4] == here.on.chain)
      neighbors.push_back(sides_.origin(before));
  });
  if (neighbors.size() != 2) return {};
  std::array<double, 2> arcs{};
  for (std::size_t i = 0; i < 2; ++i)
    arcs[i] = onChain(mesh_.vertices[neighbors[i]], here.on.chain, ground_).arc;
  const std::size_t low = arcs[1] < arcs[0] ? 1 : 0;
  const Vec3 along = (mesh_.position(neighbors[1 - low]) - mesh_.position(neighbors[low]));
  const double length2 = along.squaredNorm();
  if (!(length2 > 0)) return {};
  const double span = arcs[1 - low] - arcs[low];
  const double share = (p - here.position).dot(along) / length2;
  const double margin = kRoom * span;
  const double arc =
      std::clamp(here.on.arc + share * span, std::min(here.on.arc, arcs[low] + margin),
                 std::max(here.on.arc, arcs[1 - low] - margin));
  return ground_.onCurve({here.on.chain, arc});
}

std::optional<Placement> MovingQuads::placeNear(Index v, const Vec3& p) const {
  const Placement& here = mesh_.vertices[v];
  if (here.kind == VertexKind::Corner) return {};
  if (here.kind == VertexKind::Curve) return alongCurve(v, p);
  const SurfacePoint at = closestPointFrom(ground_.surface(), here.at, p);
  if (isAtCorner(at, ground_.surface())) return {};
  return ground_.onSurface(at);
}

bool MovingQuads::moveUnlessWorse(Index v, const Placement& place, double enough) {
  const Placement before = std::exchange(mesh_.vertices[v], place);
  const double now = qualityAround(v);
  if (now >= enough) return true;
  const Placement after = std::exchange(mesh_.vertices[v], before);
  if (now < qualityAround(v)) return false;
  mesh_.vertices[v] = after;
  return true;
}

}  // namespace remesher
