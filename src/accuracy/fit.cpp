// SPDX-License-Identifier: MIT
#include "accuracy/fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gate/angles.h"
#include "geometry/triangle.h"
#include "surface/surface_walk.h"

namespace remesher {

namespace {

// The last pass gains little; only a mesh of few vertices, where it costs little, has it.
constexpr std::size_t kFew = 8000;
constexpr int kPasses = 2, kPassesOfFew = 3, kPassesInDraft = 1;
// The least squares of offsets that neighbours share, by relaxation: a little beyond each vertex's
// own mean few passes come nearest.
constexpr double kBeyond = 1.3;
// A vertex that a pass has moved by less than this is left alone by the next.
constexpr double kStillMoves = 0.003;  // of the target length
// Angles above this may shrink, but never below it; what is below may not shrink at all. In a
// draft, which moves vertices once, the last polish sees to that.
constexpr double kKeepAngle = radians(33);

// Sample points of a triangle: two symmetric orbits of three and the centre.
constexpr double kNear = 0.7, kNearRest = 0.15, kFar = 0.1, kFarRest = 0.45;
constexpr std::array<std::array<double, 3>, 7> kSamples = {{
    {kNear, kNearRest, kNearRest},
    {kNearRest, kNear, kNearRest},
    {kNearRest, kNearRest, kNear},
    {kFar, kFarRest, kFarRest},
    {kFarRest, kFar, kFarRest},
    {kFarRest, kFarRest, kFar},
    {1.0 / 3, 1.0 / 3, 1.0 / 3},
}};

struct Offset {
  double sum = 0;
  double weight = 0;
};

// Where the samples of a triangle were found on the original: the next search begins there.
using NearFaces = std::array<Face, kSamples.size()>;

// A draft looks at the middle alone. Where the original bends evenly, the mean distance of a
// triangle whose corners lie on it is so much of that.
constexpr double kMeanOfMiddle = 0.75;

// The signed distance from the middle of a triangle to the original, for its corners.
void addMiddle(const WorkingMesh& mesh, Face f, VertexData<Offset>& offsets) {
  const auto corners = mesh.mesh().vertices(f);
  const Triangle p = mesh.corners(f);
  const Vec3 n = areaVector(p[0], p[1], p[2]), middle = (p[0] + p[1] + p[2]) / 3;
  const double area = n.norm();
  if (!(area > 0)) return;
  const OriginalSurface& surface = mesh.surface();
  const SurfacePoint near =
      closestPointFrom(surface, mesh.cornerPoint(HalfedgeMesh::halfedge(f)), middle);
  const double distance = kMeanOfMiddle * (surface.position(near) - middle).dot(n);
  for (const Vertex v : corners) {
    offsets[v].sum += distance;
    offsets[v].weight += area;
  }
}

// The signed distances from the samples of a triangle to the original, shared out to its corners.
void addOffsets(const WorkingMesh& mesh, Face f, NearFaces& near, VertexData<Offset>& offsets) {
  const auto corners = mesh.mesh().vertices(f);
  const std::array<Vec3, 3> p = {mesh.position(corners[0]), mesh.position(corners[1]),
                                 mesh.position(corners[2])};
  const Vec3 n = areaVector(p[0], p[1], p[2]);
  const double area = n.norm();
  if (!(area > 0)) return;
  const OriginalSurface& surface = mesh.surface();
  SurfacePoint point = mesh.cornerPoint(HalfedgeMesh::halfedge(f));
  for (std::size_t k = 0; k < kSamples.size(); ++k) {
    const auto& w = kSamples[k];
    const Vec3 sample = w[0] * p[0] + w[1] * p[1] + w[2] * p[2];
    if (near[k]) point.face = near[k];
    point = closestPointFrom(surface, point, sample);
    near[k] = point.face;
    const double distance = (surface.position(point) - sample).dot(n) / area;
    for (int i = 0; i < 3; ++i) {
      offsets[corners[i]].sum += area * w[i] * distance;
      offsets[corners[i]].weight += area * w[i];
    }
  }
}

bool staysGood(const WorkingMesh& mesh, Vertex v, const Vec3& to) {
  const double after = smallestAngleAround(mesh, v, to);
  return after >= kKeepAngle || after >= smallestAngleAround(mesh, v, mesh.position(v));
}

// Along the mean normal of the triangles around v, by the mean of their samples' distances.
void offsetVertex(Run& run, Vertex v, double distance) {
  run.star.gather(run.mesh, v);
  const Vec3 normal = run.star.areaVector(run.mesh.position(v));
  if (!(normal.norm() > 0)) return;
  Placement place = run.mesh.placement(v);
  place.position += distance * normal.normalized();
  if (run.quality == Quality::Best && !staysGood(run.mesh, v, place.position)) return;
  commitMove(run, v, place);
}

bool anyOf(const VertexData<char>& marked, const std::array<Vertex, 3>& corners) {
  return marked[corners[0]] || marked[corners[1]] || marked[corners[2]];
}

int passesOf(const Run& run) {
  if (run.quality == Quality::Draft) return kPassesInDraft;
  return run.mesh.mesh().vertexCount() < kFew ? kPassesOfFew : kPasses;
}

}  // namespace

void fit(Run& run, const Progress& progress) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const bool isDraft = run.quality == Quality::Draft;
  FaceData<NearFaces> near(isDraft ? 0 : mesh.faceCapacity());
  VertexData<char> moves(mesh.vertexCapacity(), 0);
  for (Index i = 0; i < mesh.vertexCapacity(); ++i)
    moves[Vertex(i)] = mesh.isAlive(Vertex(i)) && run.mesh.kind(Vertex(i)) == VertexKind::Interior;
  const int passes = passesOf(run);
  for (int pass = 0; pass < passes; ++pass) {
    progress.at(double(pass) / passes);
    VertexData<Offset> offsets(mesh.vertexCapacity());
    for (Index i = 0; i < mesh.faceCapacity(); ++i) {
      const Face f(i);
      if (!mesh.isAlive(f) || !anyOf(moves, mesh.vertices(f))) continue;
      if (isDraft)
        addMiddle(run.mesh, f, offsets);
      else
        addOffsets(run.mesh, f, near[f], offsets);
    }
    for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
      const Vertex v(i);
      if (!mesh.isAlive(v) || !moves[v] || offsets[v].weight == 0) continue;
      const double mean = offsets[v].sum / offsets[v].weight;
      const double offset = isDraft ? mean : kBeyond * mean;
      offsetVertex(run, v, offset);
      moves[v] = std::abs(offset) >= kStillMoves * run.sizes.at(run.mesh.at(v));
    }
  }
  run.mesh.settleAll();  // smoothing would undo it
}

}  // namespace remesher
