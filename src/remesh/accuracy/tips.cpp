// SPDX-License-Identifier: MIT
#include "remesh/accuracy/tips.h"

#include <algorithm>

#include "remesh/accuracy/places.h"
#include "remesh/gate/angles.h"

namespace remesher {

namespace {

std::vector<Place> farthestFirst(const Run& run) {
  std::vector<Place> places = measurePlaces(run, kLostTip, kDoubtful);
  std::erase_if(places, [&](const Place& place) {
    return place.distance <= kLostTip * run.asked.scale * run.sizes.at(place.original);
  });
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.distance > b.distance; });
  return places;
}

// A tip is worth a poor triangle for now: smoothing and polish follow.
bool moveTo(Run& run, Vertex v, const Placement& place) {
  if (run.mesh.kind(v) != VertexKind::Interior || run.mesh.isPinned(v)) return false;
  proposePlacement(run.mesh, v, place, run.scratch.change);
  return smallestComingAngle(run.mesh, run.scratch.change) >= kPoor && commit(run, lenient(run));
}

// One of the corners of the nearest triangle, the nearest first, moves to the tip.
void reach(Run& run, const Place& tip) {
  auto corners = run.mesh.mesh().vertices(tip.nearest);
  const auto distance = [&](Vertex v) {
    return (run.mesh.position(v) - tip.position).squaredNorm();
  };
  std::sort(corners.begin(), corners.end(),
            [&](Vertex a, Vertex b) { return distance(a) < distance(b); });
  // One pinned vertex reaches all the original's places around its tip.
  if (run.mesh.isPinned(corners[0])) return;
  const Placement place = run.mesh.onSurface(tip.original);
  for (const Vertex v : corners) {
    if (!moveTo(run, v, place)) continue;
    run.mesh.pin(v);
    return run.mesh.unsettleStar(v);
  }
}

}  // namespace

void reachTips(Run& run) {
  for (const Place& tip : farthestFirst(run)) reach(run, tip);
}

}  // namespace remesher
