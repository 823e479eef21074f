// SPDX-License-Identifier: MIT
// The distance between the mesh and the original, per triangle and in both directions, kept up to
// date while vertices move. It steers the lowering of the Hausdorff distance.
#pragma once

#include <optional>
#include <vector>

#include "mesh/hubs.h"
#include "original/surface/original_tree.h"
#include "remesh/accuracy/places.h"

namespace remesher {

class TwoSidedDistance {
 public:
  explicit TwoSidedDistance(const Run& run);

  // The larger of two distances: from the triangle's samples to the original, and from the places
  // of the original that belong to the triangle to the triangle.
  double of(Face f) const { return distance_[f]; }

  // The largest distance around v if v were at `to`, of those that its move changes. Above `limit`
  // it may be any value above it.
  double around(Vertex v, const Placement& to, double limit = kInfinity);

  // The largest distance around v that no move of v changes: along the rim of its star.
  double onRim(Vertex v);

  // The largest distance of the two triangles of an inner edge if it were flipped.
  double ifFlipped(Halfedge h);

  // Measures anew around a moved vertex, or the two triangles of a flipped edge. Each place there
  // goes to the nearest of these triangles.
  void update(Vertex v);
  void update(Halfedge h);

  // Vertices whose queries take too long.
  const Hubs& hubs() const { return hubs_; }

  // The number of the original's triangles looked at because walks ended too far off.
  std::size_t looked() const { return looked_; }

 private:
  // A changing triangle with the corners that it is asked about for; the moved vertex comes first.
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
  double fromOriginal(const Vec3& from, const Vec3& to, Face f, double limit = kInfinity) const;
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
  Vertex moved_;  // the vertex whose move changes them, if any
  Placement to_;
  std::vector<Index> moving_;
  Index tooFar_ = kNone;  // the place that exceeded a limit last
};

}  // namespace remesher
