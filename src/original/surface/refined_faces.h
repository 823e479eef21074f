// SPDX-License-Identifier: MIT
// Flat faces divided for values that change within them. A flat side of a machine part is a few
// large triangles from rim to rim: what is known at their corners says nothing of the middle.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "original/surface/original_surface.h"

namespace remesher {

class RefinedFaces {
 public:
  // Until no edge of a flat face is longer (model units): its longest is halved, again and again,
  // with what lies on the other side.
  RefinedFaces(const OriginalSurface& surface, double longest);

  // The original's vertices first, then the middles.
  const VertexData<Vec3>& positions() const { return positions_; }
  const std::vector<std::pair<Vertex, Vertex>>& edges() const { return edges_; }
  const VertexData<double>& areas() const { return areas_; }  // a third of that of each face around

  // Middles in the order in which they were made: the ends of the edge that each has halved.
  struct Middle {
    std::array<Vertex, 2> ends;
    bool isInFlat;  // on all its sides
  };
  const std::vector<Middle>& middles() const { return middles_; }

  // Per place the least value of the surface's faces that meet there.
  VertexData<double> leastAround(const FaceData<double>& values) const;

  // `values` at p, linear between the places known.
  double interpolate(const SurfacePoint& p, const VertexData<double>& values) const;

 private:
  // A triangle, halved at the middle of the side from corner `side` to the next, or not: its halves
  // are then nodes first and first + 1, with the corner before and after the middle.
  struct Node {
    std::array<Vertex, 3> corners;
    std::array<char, 3> isFlat =
        {};  // per side from corner i to the next: whether it may be halved
    std::array<char, 3> isInner = {};  // and whether nothing but flat faces meets there
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
  std::vector<Face> owners_;  // of each node the face that it is part of
};

}  // namespace remesher
