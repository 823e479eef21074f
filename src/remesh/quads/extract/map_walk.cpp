// SPDX-License-Identifier: MIT
#include "remesh/quads/extract/map_walk.h"

namespace remesher {

bool MapWalk::isIn(const MapPlace& place) const {
  for (int corner = 0; corner < 3; ++corner) {
    const Halfedge h = HalfedgeMesh::halfedge(place.face, corner);
    if (orientation(map_.corners[h], map_.corners[HalfedgeMesh::next(h)], place.point) < 0)
      return false;
  }
  return true;
}

// The walk leaves across the edge whose origin lies to its right and whose tip lies to its left. A
// corner on the walk always counts as left.
std::optional<Halfedge> MapWalk::exit(const MapPlace& from, const MapPoint& end,
                                      Halfedge entered) const {
  for (int corner = 0; corner < 3; ++corner) {
    const Halfedge h = HalfedgeMesh::halfedge(from.face, corner);
    if (h == entered) continue;
    const bool isRight = orientation(from.point, end, map_.corners[h]) < 0;
    const bool isLeft = orientation(from.point, end, map_.corners[HalfedgeMesh::next(h)]) >= 0;
    if (isRight && isLeft) return h;
  }
  return {};
}

// A walk within one quad crosses few triangles: one that crosses more than there are is given up.
std::optional<MapWalk::Arrival> MapWalk::go(const MapPlace& start, const MapPoint& end) const {
  MapPlace here = start;
  MapPoint goal = end;
  Transition way;
  Halfedge entered;
  for (Index step = 0; step < mesh_.faceCapacity(); ++step) {
    if (map_.area(here.face) <= 0) return {};
    if (isIn({here.face, goal})) return Arrival{{here.face, goal}, way};
    const std::optional<Halfedge> h = exit(here, goal, entered);
    if (!h || mesh_.isBoundary(*h)) return {};
    const Transition across = map_.across(mesh_, *h);
    entered = mesh_.twin(*h);
    here = {HalfedgeMesh::face(entered), across(here.point)};
    goal = across(goal);
    way = after(way, across);
  }
  return {};
}

MapSpot MapWalk::spot(const MapPlace& place) const {
  Halfedge on;
  for (int corner = 0; corner < 3; ++corner) {
    const Halfedge h = HalfedgeMesh::halfedge(place.face, corner);
    const MapPoint &a = map_.corners[h], &b = map_.corners[HalfedgeMesh::next(h)];
    if (a == place.point) return {mesh_.origin(h), {}, place};
    if (b == place.point) return {mesh_.tip(h), {}, place};
    if (orientation(a, b, place.point) == 0) on = h;
  }
  if (!on) return {{}, {}, place};
  const Halfedge twin = mesh_.twin(on);
  if (!twin || on < twin) return {{}, on, place};
  return {{}, twin, {HalfedgeMesh::face(twin), map_.across(mesh_, on)(place.point)}};
}

}  // namespace remesher
