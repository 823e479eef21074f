// SPDX-License-Identifier: MIT
// Straight walks over a seamless map, from triangle to triangle, exact.
#pragma once

#include <optional>

#include "remesh/quads/map/seamless_map.h"

namespace remesher {

// A point of the map: a triangle and a point in its coordinates.
struct MapPlace {
  Face face;
  MapPoint point;
};

// Where on the mesh a point is: at a vertex, else on an edge, else in a triangle. An edge is named
// by the lower of its halfedges, so that the same point always has the same spot.
struct MapSpot {
  Vertex vertex;
  Halfedge edge;
  MapPlace place;  // in the triangle of the edge, if it is on one
};

class MapWalk {
 public:
  MapWalk(const HalfedgeMesh& mesh, const SeamlessMap& map) : mesh_(mesh), map_(map) {}

  // Walks from a place straight to `end`, a point in the coordinates of the same triangle. None if
  // the walk leaves the surface or meets a folded triangle.
  struct Arrival {
    MapPlace place;
    Transition way;  // from the coordinates at the start to those at the end
  };
  std::optional<Arrival> go(const MapPlace& start, const MapPoint& end) const;

  bool isIn(const MapPlace& place) const;  // the closed triangle
  MapSpot spot(const MapPlace& place) const;

 private:
  std::optional<Halfedge> exit(const MapPlace& from, const MapPoint& end, Halfedge entered) const;

  const HalfedgeMesh& mesh_;
  const SeamlessMap& map_;
};

}  // namespace remesher
