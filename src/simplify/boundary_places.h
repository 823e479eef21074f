// SPDX-License-Identifier: MIT
// Where the vertices of boundaries are on the boundary loops that a surface had at first.
#pragma once

#include <vector>

#include "geometry/quadric.h"
#include "mesh/halfedge_mesh.h"

namespace remesher {

class BoundaryPlaces {
 public:
  BoundaryPlaces(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions);

  // A place on a loop: on the edge after point floor(at) of all loops.
  struct Place {
    Vec3 position;
    double at;
  };

  // The place of the smallest sum of squared distances on the loop between two neighbours, which
  // edges lead to from `from` to `to`. The quadric's places count from `center`.
  Place best(const Quadric& quadric, const Vec3& center, Vertex from, Vertex to) const;

  void move(Vertex v, double at) { at_[v] = at; }

 private:
  struct Loop {
    Index first, size;
  };
  const Loop& loopOf(double at) const;

  std::vector<Vec3> points_;
  std::vector<Loop> loops_;  // in the order of their points
  VertexData<double> at_;    // of vertices on boundaries
};

}  // namespace remesher
