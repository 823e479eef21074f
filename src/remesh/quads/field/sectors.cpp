// SPDX-License-Identifier: MIT
#include "remesh/quads/field/sectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "original/surface/surface_walk.h"

namespace remesher {

namespace {

// The angle between two edges of a curve beyond which the curve goes on.
constexpr double kGoesOn = 1.25 * kQuarterTurn;

// Closed curves have corner vertices that are no corners: a feature goes on at a corner whose angle
// is nearer to half a turn than to a quarter.
bool goesOn(VertexKind kind, double angle) {
  return kind == VertexKind::Curve ? angle > kGoesOn : std::lround(angle / kQuarterTurn) >= 2;
}

// Whether two edges lie in one of the planes.
bool areInPlane(const WorkingMesh& mesh, Halfedge a, Halfedge b, const Mirrors& mirrors) {
  const auto isIn = [&](const MirrorPlane& plane, Vertex v) {
    return std::abs(plane.distance(mesh.position(v))) <= mirrors.slack;
  };
  return std::any_of(mirrors.planes.begin(), mirrors.planes.end(), [&](const MirrorPlane& plane) {
    for (const Halfedge h : {a, b})
      if (!mesh.mesh().isBoundary(h) || !isIn(plane, mesh.mesh().origin(h)) ||
          !isIn(plane, mesh.mesh().tip(h)))
        return false;
    return true;
  });
}

double angleAt(const WorkingMesh& mesh, Halfedge h) {
  const Vec3& p = mesh.position(mesh.mesh().origin(h));
  const Vec3 out = mesh.position(mesh.mesh().tip(h)) - p;
  const Vec3 other = mesh.position(mesh.mesh().opposite(h)) - p;
  return std::atan2(out.cross(other).norm(), out.dot(other));
}

// The angle of the triangle at the tip of h.
double cornerAngle(const FaceFrames& frames, Halfedge h) {
  const Vec2 back = -frames.edge(h), out = frames.edge(HalfedgeMesh::next(h));
  return std::atan2(cross(out, back), out.dot(back));
}

// From a curve edge counterclockwise to the next one: the edges crossed, each as the halfedge
// towards the vertex in the triangle before, the last curve edge, and whether a plane that mirrors
// the quads has both curve edges.
struct Sector {
  std::vector<Halfedge> inside;
  Halfedge last;
  bool isInPlane = false;
};
Sector sectorFrom(const WorkingMesh& mesh, Halfedge first) {
  Sector sector{{}, HalfedgeMesh::prev(first)};
  while (!mesh.isCurve(sector.last)) {
    sector.inside.push_back(sector.last);
    sector.last = HalfedgeMesh::prev(mesh.mesh().twin(sector.last));
  }
  return sector;
}

// How often the cross turns from the first curve to the last, 0 to 3.
int quartersOf(const Sector& sector, Halfedge first, const CrossField& field,
               const FaceFrames& frames) {
  const auto quartersTo = [&](Halfedge h) {
    return int(std::lround((frames.angle(h) - field.angle[HalfedgeMesh::face(h)]) / kQuarterTurn));
  };
  int quarters = quartersTo(sector.last) + 2 - quartersTo(first);
  for (const Halfedge h : sector.inside) quarters -= field.turn[h];
  return ((quarters % 4) + 4) % 4;
}

// By how many quarters the cross turns too little. Open boundaries, as those of scans, bend at
// random.
int lackOf(const WorkingMesh& mesh, const FaceFrames& frames, const Sector& sector, int quarters) {
  double angle = cornerAngle(frames, sector.last);
  for (const Halfedge h : sector.inside) angle += cornerAngle(frames, h);
  const Vertex v = mesh.mesh().tip(sector.last);
  const bool isHalfTurn =
      sector.isInPlane || (!mesh.mesh().isBoundary(v) && goesOn(mesh.kind(v), angle));
  const int least = isHalfTurn ? 2 : 1;
  // Four quarters look like none: `quarters` is modulo 4.
  return angle < (least + 1) * kQuarterTurn ? std::max(least - quarters, 0) : 0;
}

// The other edges that leave the origin of h between the same two curves.
std::vector<Halfedge> besides(const WorkingMesh& mesh, Halfedge h) {
  const HalfedgeMesh& m = mesh.mesh();
  std::vector<Halfedge> found;
  for (Halfedge out = m.twin(HalfedgeMesh::prev(h)); out && out != h && !mesh.isCurve(out);
       out = m.twin(HalfedgeMesh::prev(out)))
    found.push_back(out);
  for (Halfedge twin = m.twin(h); twin;) {
    const Halfedge out = HalfedgeMesh::next(twin);
    if (out == h || mesh.isCurve(out)) break;
    found.push_back(out);
    twin = m.twin(out);
  }
  return found;
}

// The shortest way out of a sector to an inner vertex, last edge first. Near curves have no inner
// vertex between them: there the way leads through sectors of other vertices on the curves.
std::vector<Halfedge> wayInside(const WorkingMesh& mesh, const std::vector<Halfedge>& starts) {
  struct Step {
    Halfedge edge;
    std::size_t before;
  };
  std::vector<Step> steps;
  std::set<Halfedge> seen;
  const auto add = [&](const std::vector<Halfedge>& edges, std::size_t before) {
    for (const Halfedge h : edges)
      if (seen.insert(std::min(h, mesh.mesh().twin(h))).second) steps.push_back({h, before});
  };
  add(starts, 0);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (mesh.kind(mesh.mesh().tip(steps[i].edge)) != VertexKind::Interior) {
      add(besides(mesh, mesh.mesh().twin(steps[i].edge)), i);
      continue;
    }
    std::vector<Halfedge> way = {steps[i].edge};
    for (; i >= starts.size(); i = steps[i].before) way.push_back(steps[steps[i].before].edge);
    return way;
  }
  return {starts.front()};
}

// The edges that leave the vertex of a sector, the edges in its middle first.
std::vector<Halfedge> fromMiddle(const WorkingMesh& mesh, const Sector& sector) {
  std::vector<Halfedge> edges;
  const std::size_t count = sector.inside.size(), middle = count / 2;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t aside = (i + 1) / 2;
    edges.push_back(mesh.mesh().twin(sector.inside[i % 2 == 0 ? middle + aside : middle - aside]));
  }
  return edges;
}

}  // namespace

void openSectors(WorkingMesh& mesh, const Mirrors& mirrors) {
  const HalfedgeMesh& m = mesh.mesh();
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i), across = HalfedgeMesh::next(h);
    if (!mesh.isCurve(h) || !mesh.isCurve(HalfedgeMesh::prev(h)) || mesh.isCurve(across)) continue;
    const Vertex v = m.origin(h);
    const bool isHalfTurn = m.isBoundary(v) ? areInPlane(mesh, h, HalfedgeMesh::prev(h), mirrors)
                                            : goesOn(mesh.kind(v), angleAt(mesh, h));
    if (!isHalfTurn) continue;
    const Vec3 middle = (mesh.position(m.origin(across)) + mesh.position(m.tip(across))) / 2;
    mesh.split(across,
               mesh.onSurface(closestPointFrom(mesh.surface(), mesh.cornerPoint(across), middle)));
  }
}

void turnSectors(CrossField& field, const WorkingMesh& mesh, const FaceFrames& frames,
                 const Mirrors& mirrors) {
  const HalfedgeMesh& m = mesh.mesh();
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge first(i);
    if (!mesh.isCurve(first)) continue;
    Sector sector = sectorFrom(mesh, first);
    if (sector.inside.empty()) continue;
    sector.isInPlane = areInPlane(mesh, first, sector.last, mirrors);
    const int lack = lackOf(mesh, frames, sector, quartersOf(sector, first, field, frames));
    if (lack == 0) continue;
    for (const Halfedge h : wayInside(mesh, fromMiddle(mesh, sector))) {
      field.turn[h] += lack;
      field.turn[m.twin(h)] -= lack;
    }
  }
}

}  // namespace remesher
