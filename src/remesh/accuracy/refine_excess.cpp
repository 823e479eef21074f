// SPDX-License-Identifier: MIT
#include "remesh/accuracy/refine_excess.h"

#include <algorithm>
#include <vector>

#include "geometry/triangle.h"
#include "remesh/accuracy/place_finder.h"
#include "remesh/gate/angles.h"

namespace remesher {

namespace {

// Marks the faces around new or moved vertices, for which the excess found before is void.
class Touched {
 public:
  explicit Touched(const HalfedgeMesh& mesh) : mesh_(mesh), touched_(mesh.faceCapacity(), 0) {}

  bool operator[](Face f) const { return touched_[f]; }

  void around(Vertex v) {
    touched_.resize(mesh_.faceCapacity(), 1);
    mesh_.forEachOutgoing(v, [&](Halfedge h) { touched_[HalfedgeMesh::face(h)] = 1; });
  }

 private:
  const HalfedgeMesh& mesh_;
  FaceData<char> touched_;
};

// The longest of the sides that may be split.
Halfedge longestSide(const WorkingMesh& mesh, Face f) {
  Halfedge longest;
  for (int i = 0; i < 3; ++i) {
    const Halfedge h = HalfedgeMesh::halfedge(f, i);
    if (mesh.isKept(h)) continue;
    if (!longest || mesh.edgeLength(h) > mesh.edgeLength(longest)) longest = h;
  }
  return longest;
}
// Brings the mesh to places of the original that it has lost, and back to it where it has strayed.
class Refinement {
 public:
  Refinement(Run& run, Moves moves)
      : run_(run), moves_(moves), finder_(run.mesh), touched_(run.mesh.mesh()) {}

  void reach(const Lost& lost) {
    const std::vector<Vertex> near = finder_.verticesNear(lost.place);
    if (moves_ == Moves::Allowed && moveOne(near, lost.place)) return;
    if (const Face f = nearestFace(near, lost.place)) insert(f, lost.place);
  }

  void bringBack(Face f) {
    if (touched_[f] || putBackCorner(f)) return;
    if (const Halfedge side = longestSide(run_.mesh, f)) split(side);
  }

 private:
  // Of the vertices near a place the first that may moves to it.
  bool moveOne(const std::vector<Vertex>& near, const SurfacePoint& point) {
    const Placement place = run_.mesh.onSurface(point);
    for (const Vertex v : near) {
      if (run_.mesh.kind(v) != VertexKind::Interior || isTouched(v)) continue;
      if (place.position == run_.mesh.position(v)) continue;
      proposePlacement(run_.mesh, v, place, run_.scratch.change);
      if (smallestComingAngle(run_.mesh, run_.scratch.change) < kPoor || !commit(run_)) continue;
      touched_.around(v);
      return true;
    }
    return false;
  }

  bool isTouched(Vertex v) const {
    bool result = false;
    run_.mesh.mesh().forEachOutgoing(
        v, [&](Halfedge h) { result = result || touched_[HalfedgeMesh::face(h)]; });
    return result;
  }

  // The nearest of the faces around `near`; none if it has changed.
  Face nearestFace(const std::vector<Vertex>& near, const SurfacePoint& point) const {
    const Vec3 target = run_.mesh.surface().position(point);
    Face nearest;
    double least = kInfinity;
    for (const Vertex v : near)
      run_.mesh.mesh().forEachOutgoing(v, [&](Halfedge h) {
        const auto [a, b, c] = run_.mesh.mesh().vertices(HalfedgeMesh::face(h));
        const Vec3 closest = closestPoint(target, run_.mesh.position(a), run_.mesh.position(b),
                                          run_.mesh.position(c));
        const double distance = (closest - target).squaredNorm();
        if (distance >= least) return;
        least = distance;
        nearest = HalfedgeMesh::face(h);
      });
    return nearest && touched_[nearest] ? Face() : nearest;
  }

  // Splits a side of the face: at the place if that makes good triangles, else in the middle of the
  // longest.
  void insert(Face f, const SurfacePoint& point) {
    const Placement place = run_.mesh.onSurface(point);
    for (int i = 0; i < 3; ++i) {
      const Halfedge h = HalfedgeMesh::halfedge(f, i);
      if (run_.mesh.isCurve(h) || !proposeSplit(run_.mesh, run_.projector, h, run_.scratch.change))
        continue;
      run_.scratch.change.place = place;
      if (smallestComingAngle(run_.mesh, run_.scratch.change) < kPoor || !commit(run_)) continue;
      return touched_.around(run_.scratch.result);
    }
    if (const Halfedge side = longestSide(run_.mesh, f)) split(side);
  }

  void split(Halfedge h) {
    if (proposeSplit(run_.mesh, run_.projector, h, run_.scratch.change) && commitUnlessFlat(run_))
      touched_.around(run_.scratch.result);
  }

  // Fitting and the mending of poor triangles leave vertices off the original. Puts one such corner
  // back; once moves are over, even if that folds the mesh over.
  bool putBackCorner(Face f) {
    for (const Vertex v : run_.mesh.mesh().vertices(f)) {
      if (run_.mesh.kind(v) != VertexKind::Interior) continue;
      const Placement place = run_.mesh.onSurface(run_.mesh.at(v));
      if (place.position == run_.mesh.position(v)) continue;
      proposePlacement(run_.mesh, v, place, run_.scratch.change);
      if (!(moves_ == Moves::Never ? commitUnlessFlat(run_) : commit(run_, lenient(run_))))
        continue;
      touched_.around(v);
      return true;
    }
    return false;
  }

  Run& run_;
  Moves moves_;
  PlaceFinder finder_;
  Touched touched_;
};

}  // namespace

void refineExcess(Run& run, const Excess& excess, Moves moves) {
  Refinement refinement(run, moves);
  for (const Lost& lost : excess.lost) refinement.reach(lost);
  for (const Face f : excess.stray) refinement.bringBack(f);
}

}  // namespace remesher
