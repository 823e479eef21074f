// SPDX-License-Identifier: MIT
// Straight ways over a seamless map, from triangle to triangle, exactly.
#pragma once

#include <optional>

#include "remesh/quads/map/seamless_map.h"

namespace remesher {

// A point of the map: in a triangle, by that triangle's coordinates.
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

  // From a place straight to `end`, a point in the coordinates of the same triangle. None where the
  // way leaves the surface, or meets a triangle that is folded over.
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
