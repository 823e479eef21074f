// SPDX-License-Identifier: MIT
#include "remesh/accuracy/fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/triangle.h"
#include "original/surface/surface_walk.h"
#include "remesh/accuracy/narrowest.h"
#include "remesh/gate/angles.h"
#include "remesh/steps/relax.h"

namespace remesher {

namespace {

// The weights, at each corner and at the middle, of a rule for means over a triangle that is exact
// to squares. The corners cost nothing, since their places are known.
constexpr double kAtCorner = 1.0 / 12, kAtMiddle = 3.0 / 4;

// Per vertex the mean distance of the triangles around it to the original, signed along their
// normals. Each sample counts by the vertex's weight among the three corners.
class Offsets {
 public:
  explicit Offsets(const WorkingMesh& mesh)
      : mesh_(mesh), middles_(mesh.mesh().vertexCapacity()), found_(mesh.mesh().faceCapacity()) {}

  void clear() { middles_.assign(middles_.size(), {}); }

  void addMiddle(Face f) {
    const auto [a, b, c] = mesh_.corners(f);
    const Vec3 normal = areaVector(a, b, c), middle = (a + b + c) / 3;
    const double volume = wayToOriginal(f, middle).dot(normal);
    for (const Vertex v : mesh_.mesh().vertices(f)) {
      middles_[v].volume += kAtMiddle / 3 * volume;
      middles_[v].area += normal.norm() / 3;
    }
  }

  // Once the middles around v are known. normal: the sum of the area vectors around it. 0 where the
  // triangles around v had no area then.
  double at(Vertex v, const Vec3& normal) const {
    if (!(middles_[v].area > 0)) return 0;
    const Vec3 way = mesh_.surface().position(mesh_.at(v)) - mesh_.position(v);
    return (middles_[v].volume + kAtCorner * way.dot(normal)) / middles_[v].area;
  }

 private:
  struct Sum {
    double volume = 0;  // areas times distances
    double area = 0;
  };

  // From the middle of f, by a walk from its first corner, or from where the last one has ended.
  Vec3 wayToOriginal(Face f, const Vec3& middle) {
    const OriginalSurface& surface = mesh_.surface();
    const SurfacePoint start = found_[f] ? SurfacePoint{found_[f], Vec3::Constant(1.0 / 3)}
                                         : mesh_.cornerPoint(HalfedgeMesh::halfedge(f));
    const SurfacePoint point = closestPointFrom(surface, start, middle);
    found_[f] = point.face;
    return surface.position(point) - middle;
  }

  const WorkingMesh& mesh_;
  VertexData<Sum> middles_;
  FaceData<Face> found_;  // the face of the original nearest to each middle
};

// Sound angles may shrink, but stay sound; other angles may not shrink at all. If vertices move
// only once, this is left to the last polish.
bool staysGood(const Run& run, Vertex v, const Vec3& to) {
  const double after = narrowestAround(run, v, to);
  return after >= kSound || after >= narrowestAround(run, v, run.mesh.position(v));
}

// Moves v along the mean normal of the triangles around it. Returns how far.
double offsetVertex(Run& run, Vertex v, const Offsets& offsets) {
  const bool isOnce = run.asked.effort.fitPasses == 1;
  run.scratch.star.gather(run.mesh, v);
  const Vec3 normal = run.scratch.star.areaVector(run.mesh.position(v));
  if (!(normal.norm() > 0)) return 0;
  const double distance = (isOnce ? 1 : kBeyondMean) * offsets.at(v, normal);
  Placement place = run.mesh.placement(v);
  place.position += distance * normal.normalized();
  if (isOnce || staysGood(run, v, place.position)) commitMove(run, v, place);
  return distance;
}

bool anyOf(const VertexData<char>& marked, const std::array<Vertex, 3>& corners) {
  return marked[corners[0]] || marked[corners[1]] || marked[corners[2]];
}

}  // namespace

void fit(Run& run, const Progress& progress) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  Offsets offsets(run.mesh);
  VertexData<char> moves(mesh.vertexCapacity(), 0);
  for (Index i = 0; i < mesh.vertexCapacity(); ++i)
    moves[Vertex(i)] = mesh.isAlive(Vertex(i)) &&
                       run.mesh.kind(Vertex(i)) == VertexKind::Interior &&
                       !run.mesh.surface().isFlatAt(run.mesh.at(Vertex(i)));
  const int passes = run.asked.effort.fitPasses;
  for (int pass = 0; pass < passes; ++pass) {
    progress.at(double(pass) / passes);
    offsets.clear();
    for (Index i = 0; i < mesh.faceCapacity(); ++i)
      if (mesh.isAlive(Face(i)) && anyOf(moves, mesh.vertices(Face(i)))) offsets.addMiddle(Face(i));
    for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
      const Vertex v(i);
      if (!mesh.isAlive(v) || !moves[v]) continue;
      const double offset = offsetVertex(run, v, offsets);
      moves[v] = std::abs(offset) >= run.asked.effort.rest * run.sizes.at(run.mesh.at(v));
    }
  }
  run.mesh.settleAll();  // smoothing would undo it
}

}  // namespace remesher
