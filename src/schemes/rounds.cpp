// SPDX-License-Identifier: MIT
#include "schemes/rounds.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"
#include "operators/delaunay.h"
#include "schemes/split_obtuse.h"
#include "schemes/sweeps.h"

namespace remesher {

namespace {

constexpr int kAreaSweeps = 3;
constexpr int kAreaRounds = 10;
constexpr int kLaplacianRounds = 10;
// An edge more than twice as long as another of its triangles is too long to collapse.
constexpr double kTooLong = 2;

double minAngleOf(const WorkingMesh& mesh, Face f) {
  const auto [a, b, c] = mesh.mesh().vertices(f);
  return minAngle(mesh.position(a), mesh.position(b), mesh.position(c));
}

double length(const WorkingMesh& mesh, Halfedge h) {
  return (mesh.position(mesh.mesh().tip(h)) - mesh.position(mesh.mesh().origin(h))).norm();
}

bool isLongest(const WorkingMesh& mesh, Halfedge side) {
  const double own = length(mesh, side);
  return own >= length(mesh, mesh.mesh().next(side)) && own >= length(mesh, mesh.mesh().prev(side));
}

struct Ranked {
  double key;  // first come the largest
  Halfedge edge;
};

// All edges with their keys, worst (splits) or best (collapses) first, ties by index.
template <class Key>
std::vector<Ranked> rankedEdges(const WorkingMesh& mesh, Key key) {
  std::vector<Ranked> edges;
  for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); ++i)
    if (mesh.mesh().isEdge(Halfedge(i))) edges.push_back({key(Halfedge(i)), Halfedge(i)});
  std::stable_sort(edges.begin(), edges.end(),
                   [](const Ranked& a, const Ranked& b) { return a.key > b.key; });
  return edges;
}

// How bad the triangles of an edge are; boundary edges come before all others.
double badness(const WorkingMesh& mesh, Halfedge h) {
  const HalfedgeMesh& m = mesh.mesh();
  const auto shortfall = [&](Face f) {
    const double missing = radians(60) - minAngleOf(mesh, f);
    return missing * missing;
  };
  constexpr double kBoundaryFirst = 1e3;
  if (m.isBoundary(h)) return kBoundaryFirst + shortfall(m.face(h));
  return shortfall(m.face(h)) + shortfall(m.face(m.twin(h)));
}

double goodness(const WorkingMesh& mesh, Halfedge h) {
  const HalfedgeMesh& m = mesh.mesh();
  if (m.isBoundary(h)) return minAngleOf(mesh, m.face(h));
  return std::max(minAngleOf(mesh, m.face(h)), minAngleOf(mesh, m.face(m.twin(h))));
}

// One round of insertion: the longest edges of the worst triangles, no triangle twice.
std::size_t splitRound(Run& run, std::size_t target) {
  const HalfedgeMesh& m = run.mesh.mesh();
  FaceData<char> touched(m.faceCapacity(), 0);
  std::size_t splits = 0;
  for (const auto& [key, h] :
       rankedEdges(run.mesh, [&](Halfedge e) { return badness(run.mesh, e); })) {
    if (m.vertexCount() >= target) break;
    const Halfedge t = m.twin(h);
    if (touched[m.face(h)] || (t && touched[m.face(t)])) continue;
    if (!isLongest(run.mesh, h) || (t && !isLongest(run.mesh, t))) continue;
    if (!proposeSplit(run.mesh, run.projector, h, run.change)) continue;
    const Vertex made = apply(run.mesh, run.change);
    ++splits;
    touched.resize(m.faceCapacity(), 1);
    m.forEachOutgoing(made, [&](Halfedge around) { touched[m.face(around)] = 1; });
  }
  return splits;
}

bool isTooLong(const WorkingMesh& mesh, Halfedge h) {
  const double own = length(mesh, h);
  for (const Halfedge side : {h, mesh.mesh().twin(h)}) {
    if (!side) continue;
    for (const Halfedge other : {mesh.mesh().next(side), mesh.mesh().prev(side)})
      if (own > kTooLong * length(mesh, other)) return true;
  }
  return false;
}

// Whether the collapse happened. Where one end may not leave its place, the other may.
bool tryCollapse(Run& run, Halfedge h) {
  for (const Halfedge direction : {h, run.mesh.mesh().twin(h)})
    if (direction && proposeCollapse(run.mesh, run.projector, direction, run.change))
      return commit(run);
  return false;
}

// One round of collapses: the edges of the best triangles, no star twice.
std::size_t collapseRound(Run& run, std::size_t target) {
  const HalfedgeMesh& m = run.mesh.mesh();
  FaceData<char> touched(m.faceCapacity(), 0);
  std::size_t collapses = 0;
  for (const auto& [key, h] :
       rankedEdges(run.mesh, [&](Halfedge e) { return goodness(run.mesh, e); })) {
    if (m.vertexCount() <= target) break;
    if (!m.isAlive(h)) continue;
    const Halfedge t = m.twin(h);
    if (touched[m.face(h)] || (t && touched[m.face(t)]) || isTooLong(run.mesh, h)) continue;
    if (!tryCollapse(run, h)) continue;
    ++collapses;
    m.forEachOutgoing(run.result, [&](Halfedge around) { touched[m.face(around)] = 1; });
  }
  return collapses;
}

void areaBasedRound(Run& run) {
  for (int i = 0; i < kAreaSweeps; ++i) areaBasedSweep(run);
  delaunayFlips(run.mesh, run.rule);
}

// Most of the time goes into the rounds that change the number of vertices, if there are any.
double changingShare(std::size_t from, std::size_t to) {
  const double rounds = 4 * std::abs(std::log2(double(to) / double(from)));
  return rounds / (rounds + kAreaRounds + 0.3 * kLaplacianRounds);
}

}  // namespace

bool runRounds(Run& run, const RoundsGoal& goal, const Progress& progress) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const double start = double(mesh.vertexCount()), way = double(goal.vertices) - start;
  const double share = changingShare(mesh.vertexCount(), goal.vertices);
  std::size_t changes = 1;
  while (mesh.vertexCount() != goal.vertices && changes > 0) {
    progress.at(share * (double(mesh.vertexCount()) - start) / way);
    changes = mesh.vertexCount() < goal.vertices ? splitRound(run, goal.vertices)
                                                 : collapseRound(run, goal.vertices);
    areaBasedRound(run);
  }
  const bool reached = mesh.vertexCount() == goal.vertices;
  if (goal.splitObtuse) splitObtuse(run);
  const Progress finish = progress.part("smooth", share, 1);
  for (int i = 0; i < kAreaRounds; ++i) {
    finish.at(0.8 * i / kAreaRounds);
    areaBasedRound(run);
  }
  for (int i = 0; i < kLaplacianRounds; ++i) {
    finish.at(0.8 + 0.2 * i / kLaplacianRounds);
    laplacianSweep(run);
  }
  return reached;
}

}  // namespace remesher
