// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/thin_protrusions.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "geometry/distance_sampler.h"
#include "geometry/mesh_tree.h"
#include "mesh/shortest_paths.h"
#include "original/surface/surface_walk.h"
#include "remesh/quads/mesh/quad_distance.h"
#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/quads/mesh/triangulated.h"

namespace remesher {

namespace {

// Farther along the surface than this, in mean sides, no quad reaches from one of its corners.
constexpr double kBeyondQuads = 2.5;

// Goes on along edges of the ground, up to the first vertex of which isEnd(vertex) is true; none if
// there is none.
template <class IsEnd>
Vertex goAlong(const WorkingMesh& ground, ShortestPaths& paths, IsEnd isEnd) {
  Vertex v;
  while ((v = paths.leave()) && !isEnd(v))
    ground.mesh().forEachNeighbor(v, [&](Vertex w) {
      paths.reach(w, paths[v] + (ground.position(w) - ground.position(v)).norm());
    });
  return v;
}

// How far each vertex of the ground is from the corners of quads, along the ground.
ShortestPaths alongGround(const QuadMesh& mesh, const WorkingMesh& ground, const MeshTree& tree) {
  ShortestPaths paths(ground.mesh().vertexCapacity());
  Face near;
  for (const Placement& place : mesh.vertices) {
    near = tree.nearest(place.position, near).face;
    for (const Vertex v : ground.mesh().vertices(near)) {
      const bool isSameSide =
          place.kind != VertexKind::Interior || ground.normal(v).dot(place.normal) > 0;
      if (isSameSide) paths.reach(v, (ground.position(v) - place.position).norm());
    }
  }
  goAlong(ground, paths, [](Vertex) { return false; });
  return paths;
}

// How far each vertex of the ground is from the quads, and the nearest quad. What no quad reaches
// along the surface is as far from them as along it: a tail may lie beside quads of the body.
struct FromQuads {
  VertexData<double> distance;
  VertexData<Index> quad;
};

FromQuads distancesFrom(const QuadMesh& mesh, const WorkingMesh& ground, const MeshTree& ofGround) {
  const QuadTree tree(mesh);
  const ShortestPaths along = alongGround(mesh, ground, ofGround);
  const auto count = Index(ground.mesh().vertexCapacity());
  FromQuads result{VertexData<double>(count), VertexData<Index>(count, kNone)};
  const double beyond = kBeyondQuads * meanSide(mesh);
  DistanceSampler sampler(*tree);
  for (Index i = 0; i < count; ++i) {
    const Vertex v(i);
    const double inSpace = std::sqrt(sampler.add(ground.position(v)));
    result.distance[v] = along[v] > beyond ? along[v] : inSpace;
    result.quad[v] = sampler.near() / 2;
  }
  return result;
}

// The part of the ground around a tip, as far as the quads: how far its vertices are from the tip
// along edges, and where it meets the quads.
struct Protrusion {
  ShortestPaths gone;  // kInfinity beyond
  double length = 0;
  Index quad = kNone;
};

Protrusion protrusionAt(Vertex tip, const WorkingMesh& ground, const FromQuads& from, double near) {
  Protrusion protrusion{ShortestPaths(ground.mesh().vertexCapacity())};
  protrusion.gone.reach(tip, 0);
  const Vertex end =
      goAlong(ground, protrusion.gone, [&](Vertex v) { return from.distance[v] < near; });
  if (!end) return protrusion;
  protrusion.length = protrusion.gone[end];
  protrusion.quad = from.quad[end];
  return protrusion;
}

struct RingPoint {
  Halfedge edge;  // from nearer to the tip to farther from it
  Vec3 position;
};

using Ring = std::vector<RingPoint>;

double lengthOf(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += (ring[(i + 1) % ring.size()].position - ring[i].position).norm();
  return sum;
}

// The longest closed line around the tip, counterclockwise, at a distance from the tip; none if a
// line ends on a boundary.
Ring ringAt(double distance, const WorkingMesh& ground, const Protrusion& protrusion) {
  const HalfedgeMesh& m = ground.mesh();
  const auto isWithin = [&](Vertex v) { return protrusion.gone[v] < distance; };
  const auto leaves = [&](Halfedge h) { return isWithin(m.origin(h)) && !isWithin(m.tip(h)); };
  HalfedgeData<char> seen(m.halfedgeCapacity(), 0);
  Ring longest;
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    Ring ring;
    for (Halfedge h(i); leaves(h) && !seen[h];) {
      seen[h] = 1;
      const Vertex a = m.origin(h), b = m.tip(h);
      const double share =
          (distance - protrusion.gone[a]) / (protrusion.gone[b] - protrusion.gone[a]);
      ring.push_back({h, (1 - share) * ground.position(a) + share * ground.position(b)});
      const Halfedge next = HalfedgeMesh::next(h);
      h = m.twin(isWithin(m.tip(next)) ? next : HalfedgeMesh::prev(h));
      if (!h) return {};
    }
    if (lengthOf(ring) > lengthOf(longest)) longest = std::move(ring);
  }
  return longest;
}

// Four points of a ring as far apart from each other as can be, along it, from a point on.
Four<RingPoint> quarters(const Ring& ring, std::size_t first) {
  const double quarter = lengthOf(ring) / 4;
  Four<RingPoint> points;
  double gone = 0;
  std::size_t at = first;
  for (std::size_t i = 0; i < 4; ++i) {
    for (;;) {
      const RingPoint &a = ring[at % ring.size()], &b = ring[(at + 1) % ring.size()];
      const double length = (b.position - a.position).norm(), left = double(i) * quarter - gone;
      if (left <= length || at > first + ring.size()) {
        const double share = length > 0 ? std::clamp(left / length, 0.0, 1.0) : 0;
        points[i] = {a.edge, (1 - share) * a.position + share * b.position};
        break;
      }
      gone += length;
      ++at;
    }
  }
  return points;
}

// Those nearest to the corners of a quad.
Four<RingPoint> quartersBeside(const Ring& ring, const QuadMesh& mesh, Index quad) {
  Four<RingPoint> best;
  double least = kInfinity;
  for (std::size_t first = 0; first < ring.size(); ++first) {
    const Four<RingPoint> points = quarters(ring, first);
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i)
      sum += (points[i].position - mesh.position(mesh.quads[quad][i])).squaredNorm();
    if (!(sum < least)) continue;
    least = sum;
    best = points;
  }
  return best;
}

// Puts a ring of four quads around the quad, which moves to the four points.
void addRing(QuadMesh& mesh, Index quad, const Four<RingPoint>& points, const WorkingMesh& ground) {
  Four<Index> inner{};
  for (std::size_t i = 0; i < 4; ++i) {
    inner[i] = Index(mesh.vertices.size());
    mesh.vertices.push_back(ground.onSurface(closestPointFrom(
        ground.surface(), ground.cornerPoint(points[i].edge), points[i].position)));
  }
  surround(mesh, quad, inner);
}

}  // namespace

void growThinProtrusions(QuadMesh& mesh, const WorkingMesh& ground) {
  const double side = meanSide(mesh);
  const MeshTree tree(ground.mesh(), ground.positions());
  VertexData<char> isTried(ground.mesh().vertexCapacity(), 0);
  for (;;) {
    const FromQuads from = distancesFrom(mesh, ground, tree);
    Vertex tip;
    double farthest = side;
    for (Index i = 0; i < isTried.size(); ++i)
      if (const Vertex v(i); !isTried[v] && from.distance[v] > farthest) {
        farthest = from.distance[v];
        tip = v;
      }
    if (!tip) return;
    const Protrusion protrusion = protrusionAt(tip, ground, from, side / 4);
    for (Index i = 0; i < isTried.size(); ++i)
      isTried[Vertex(i)] |= protrusion.gone[Vertex(i)] < kInfinity;
    if (protrusion.quad == kNone) continue;
    const double rings = std::max(1.0, std::round(protrusion.length / side));
    // A spike of a wild coordinate would need millions.
    if (double(mesh.quads.size()) + 4 * rings > double(ground.mesh().faceCount())) continue;
    for (double k = 1; k <= rings; ++k) {
      const Ring ring = ringAt(protrusion.length * (1 - k / (rings + 0.5)), ground, protrusion);
      if (ring.empty()) break;
      addRing(mesh, protrusion.quad, quartersBeside(ring, mesh, protrusion.quad), ground);
    }
  }
}

}  // namespace remesher
