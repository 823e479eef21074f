// SPDX-License-Identifier: MIT
// How far the mesh and the original are apart, triangle by triangle and in both directions, kept up
// to date while vertices move: what lowering the Hausdorff distance steers by.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "mesh/hubs.h"
#include "original/surface/original_tree.h"
#include "remesh/accuracy/places.h"

namespace remesher {

class TwoSidedDistance {
 public:
  explicit TwoSidedDistance(const Run& run);

  // The largest distance from the triangle's samples to the original, and to the triangle from the
  // places that belong to it.
  double of(Face f) const { return distance_[f]; }

  // The largest of those that a move of v changes, were v there; any larger one where it exceeds
  // `limit`.
  double around(Vertex v, const Placement& to,
                double limit = std::numeric_limits<double>::infinity());

  // The largest of those around v that no move of v changes: along the rim of its star.
  double onRim(Vertex v);

  // The largest of those of the two triangles of an inner edge, were it flipped.
  double ifFlipped(Halfedge h);

  // Measures anew around a vertex that has moved, or the two triangles of an edge that was flipped:
  // places there go over to the nearest triangle.
  void update(Vertex v);
  void update(Halfedge h);

  // Vertices that it takes too long to ask about.
  const Hubs& hubs() const { return hubs_; }

  // The triangles of the original looked at because walks to it ended too far off.
  std::size_t looked() const { return looked_; }

 private:
  // A triangle that changes, with its corners where it is asked about: the moved vertex comes
  // first.
  struct Changed {
    Face face;
    Triangle at;
  };

  void gather(Vertex v, const Placement& to);
  bool isGathered(Face f) const;
  double distanceNear(Place place) const;
  bool isNear(const Place& place, const Changed& own, double distance) const;
  double farthestPlace(double limit);
  void measureGathered();
  void measureNear(Place& place) const;
  SurfacePoint startAt(Halfedge corner) const;
  SurfacePoint startNear(const Vec3& sample, Face f) const;
  double fromOriginal(const Vec3& sample, SurfacePoint& place) const;
  double fromOriginal(const Vec3& sample, Face f) const;
  double fromOriginal(const Vec3& from, const Vec3& to, Face f,
                      double limit = std::numeric_limits<double>::infinity()) const;
  double fromOriginal(const Triangle& triangle, Face f) const;
  bool followsOriginal(Halfedge h) const;
  void raise(Face f, double distance);
  void add(Index place);
  void measureFaces();

  const WorkingMesh& mesh_;
  const Hubs hubs_;
  const double doubtful_;
  const bool originalIsCoarse_;
  std::vector<Place> places_;
  std::vector<Index> next_;  // the next place of the same triangle, or kNone
  FaceData<Index> first_;    // the first place of a triangle, or kNone
  FaceData<double> distance_;
  std::optional<OriginalTree> own_;  // if the run has none
  OriginalTree& tree_;
  mutable std::size_t looked_ = 0;
  std::vector<Changed> gathered_;
  Vertex moved_;  // that they change with, if any
  Placement to_;
  std::vector<Index> moving_;
  Index tooFar_ = kNone;  // the place that exceeded a limit last
};

}  // namespace remesher
