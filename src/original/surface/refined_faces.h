// SPDX-License-Identifier: MIT
// Flat faces divided for values that change within them. A flat side of a machine part consists of
// a few large triangles from rim to rim: values at their corners say nothing of the middle.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "original/surface/original_surface.h"

namespace remesher {

class RefinedFaces {
 public:
  // Halves the longest edge of flat faces, in both faces of the edge, until none is longer than
  // `longest` (model units).
  RefinedFaces(const OriginalSurface& surface, double longest);

  // The original's vertices first, then the middles.
  const VertexData<Vec3>& positions() const { return positions_; }
  const std::vector<std::pair<Vertex, Vertex>>& edges() const { return edges_; }
  const VertexData<double>& areas() const { return areas_; }  // a third of the areas around each

  // Middles in the order in which they were made: the ends of the halved edge.
  struct Middle {
    std::array<Vertex, 2> ends;
    bool isInFlat;  // all faces at the edge are flat
  };
  const std::vector<Middle>& middles() const { return middles_; }

  // Per place the least value of the original faces that meet there.
  VertexData<double> leastAround(const FaceData<double>& values) const;

  // `values` at p, interpolated linearly between the places.
  double interpolate(const SurfacePoint& p, const VertexData<double>& values) const;

 private:
  // A triangle. Unless first is kNone it is halved at the middle of the side from corner `side` to
  // the next: node `first` keeps the corner before the middle, node first + 1 the corner after it.
  struct Node {
    std::array<Vertex, 3> corners;
    std::array<char, 3> isFlat =
        {};  // per side from corner i to the next: whether it may be halved
    std::array<char, 3> isInner = {};  // and whether all faces there are flat
    Index first = kNone;
    int side = 0;
    Vertex middle;
  };
  class Builder;

  VertexData<Vec3> positions_;
  VertexData<double> areas_;
  std::vector<std::pair<Vertex, Vertex>> edges_;
  std::vector<Middle> middles_;
  std::vector<Node> nodes_;   // the original's faces first
  std::vector<Face> owners_;  // per node the face that holds it
};

}  // namespace remesher
