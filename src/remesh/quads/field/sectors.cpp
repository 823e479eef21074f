// SPDX-License-Identifier: MIT
#include "remesh/quads/field/sectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "original/surface/surface_walk.h"

namespace remesher {

namespace {

constexpr double kQuarterTurn = std::numbers::pi / 2;
// Between two edges of a curve that is hardly a corner.
constexpr double kGoesOn = 1.25 * kQuarterTurn;

double angleAt(const WorkingMesh& mesh, Halfedge h) {
  const Vec3& p = mesh.position(mesh.mesh().origin(h));
  const Vec3 out = mesh.position(mesh.mesh().tip(h)) - p;
  const Vec3 other = mesh.position(mesh.mesh().opposite(h)) - p;
  return std::atan2(out.cross(other).norm(), out.dot(other));
}

// Of a triangle at the vertex where the edge ends.
double cornerAngle(const FaceFrames& frames, Halfedge h) {
  const Vec2 back = -frames.edge(h), out = frames.edge(HalfedgeMesh::next(h));
  return std::atan2(cross(out, back), out.dot(back));
}

// From a curve counterclockwise to the next one: the edges that are crossed, each as the halfedge
// towards the vertex in the triangle before, and the curve there.
struct Sector {
  std::vector<Halfedge> inside;
  Halfedge last;
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

// By how much the cross turns too little. Open boundaries, as those of scans, bend at random.
int lackOf(const WorkingMesh& mesh, const FaceFrames& frames, const Sector& sector, int quarters) {
  double angle = cornerAngle(frames, sector.last);
  for (const Halfedge h : sector.inside) angle += cornerAngle(frames, h);
  const Vertex v = mesh.mesh().tip(sector.last);
  const bool isFeature = mesh.kind(v) == VertexKind::Curve && !mesh.mesh().isBoundary(v);
  const int least = isFeature && angle > kGoesOn ? 2 : 1;
  // None of four quarters looks like none at all.
  return angle < (least + 1) * kQuarterTurn ? std::max(least - quarters, 0) : 0;
}

}  // namespace

void openSectors(WorkingMesh& mesh) {
  const HalfedgeMesh& m = mesh.mesh();
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i), across = HalfedgeMesh::next(h);
    if (!mesh.isCurve(h) || !mesh.isCurve(HalfedgeMesh::prev(h)) || mesh.isCurve(across)) continue;
    const Vertex v = m.origin(h);
    if (mesh.kind(v) != VertexKind::Curve || m.isBoundary(v) || angleAt(mesh, h) < kGoesOn)
      continue;
    const Vec3 middle = (mesh.position(m.origin(across)) + mesh.position(m.tip(across))) / 2;
    mesh.split(across,
               mesh.onSurface(closestPointFrom(mesh.surface(), mesh.cornerPoint(across), middle)));
  }
}

void turnSectors(CrossField& field, const WorkingMesh& mesh, const FaceFrames& frames) {
  const HalfedgeMesh& m = mesh.mesh();
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge first(i);
    if (!mesh.isCurve(first)) continue;
    const Sector sector = sectorFrom(mesh, first);
    if (sector.inside.empty()) continue;
    const int lack = lackOf(mesh, frames, sector, quartersOf(sector, first, field, frames));
    const Halfedge middle = sector.inside[sector.inside.size() / 2];
    field.turn[middle] -= lack;
    field.turn[m.twin(middle)] += lack;
  }
}

}  // namespace remesher
