// SPDX-License-Identifier: MIT
#include "remesh/steps/subdivide.h"

#include <algorithm>
#include <cstdint>

#include "geometry/triangle.h"
#include "original/surface/surface_walk.h"

namespace remesher {

namespace {

std::size_t countEdges(const HalfedgeMesh& mesh) {
  std::size_t boundary = 0;
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i)
    boundary += mesh.isAlive(Halfedge(i)) && mesh.isBoundary(Halfedge(i));
  return (3 * mesh.faceCount() + boundary) / 2;
}

// The place of an edge's middle. In a tube of only three edges around, an edge runs through the
// inside: both walls are equally near, and a patch may hold either. Seen from outside, the nearest
// wall is the edge's own. No gate judges what subdivision makes.
Placement middleOf(Run& run, Halfedge h) {
  const WorkingMesh& mesh = run.mesh;
  const Placement place = midpoint(mesh, run.projector, h);
  if (mesh.isCurve(h) || run.projector.mode() == Projection::Current) return place;
  const HalfedgeMesh& m = mesh.mesh();
  const Vec3 &a = mesh.position(m.origin(h)), &b = mesh.position(m.tip(h));
  const Vec3 middle = 0.5 * (a + b);
  const double length = distance(a, b);
  const Vec3 &c = mesh.position(m.opposite(h)), &d = mesh.position(m.opposite(m.twin(h)));
  const Vec3 outward = (b - a).cross(c - d);  // the sum of the area vectors on both sides
  if (outward.dot(place.normal) >= 0) return place;
  const Vec3 outside = middle + 0.5 * length * outward.normalized();
  const Placement facing =
      mesh.onSurface(closestPointFrom(mesh.surface(), mesh.cornerPoint(h), outside));
  return outward.dot(facing.normal) > 0 ? facing : place;
}

}  // namespace

void subdivide(Run& run) {
  run.mesh.compact();
  const HalfedgeMesh& mesh = run.mesh.mesh();
  std::vector<Placement> midpoints;
  midpoints.reserve(countEdges(mesh));
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i)
    if (mesh.isEdge(Halfedge(i))) midpoints.push_back(middleOf(run, Halfedge(i)));
  run.mesh.subdivide(midpoints);
  run.asked.scale /= 2;
}

std::size_t coarseCount(const HalfedgeMesh& mesh, std::size_t vertices, int levels) {
  const std::size_t fewest = vertices >> (2 * levels);
  // One vertex more brings three edges and two faces, by Euler's formula; signed, since many small
  // parts may have fewer than this takes away.
  const std::int64_t more = std::int64_t(fewest) - std::int64_t(mesh.vertexCount());
  std::int64_t v = std::int64_t(fewest), e = std::int64_t(countEdges(mesh)) + 3 * more;
  std::int64_t f = std::int64_t(mesh.faceCount()) + 2 * more;
  for (int i = 0; i < levels; ++i) {
    v += e;
    e = 2 * e + 3 * f;
    f *= 4;
  }
  // Each vertex becomes four to the power of the levels.
  const std::int64_t missing = std::max(std::int64_t{0}, std::int64_t(vertices) - v),
                     each = std::int64_t{1} << (2 * levels);
  return fewest + std::size_t((missing + each - 1) / each);
}

}  // namespace remesher
