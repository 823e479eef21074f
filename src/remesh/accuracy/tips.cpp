// SPDX-License-Identifier: MIT
#include "remesh/accuracy/tips.h"

#include <algorithm>

#include "remesh/accuracy/places.h"
#include "remesh/gate/angles.h"

namespace remesher {

namespace {

// Of the distance of a lost tip: a place this near to a tangent plane is no tip.
constexpr double kSurelyNear = 0.4;

// A tip farther than this from the mesh, in target lengths, that no vertex can move to gets a
// vertex of its own, though that makes four triangles of two.
constexpr double kInsertAbove = 0.6;

std::vector<Place> farthestFirst(const Run& run) {
  std::vector<Place> places = measurePlaces(run, kLostTip, kSurelyNear * kLostTip);
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

// Splits a side of the nearest triangle by a vertex on the tip: the side whose split leaves the
// widest angles.
void insert(Run& run, const Place& tip) {
  double best = kSliver;
  LocalChange change;
  const Placement place = run.mesh.onSurface(tip.original);
  for (int i = 0; i < 3; ++i) {
    const Halfedge h = HalfedgeMesh::halfedge(tip.nearest, i);
    if (run.mesh.isCurve(h) || !proposeSplitAt(run.mesh, place, h, run.scratch.change)) continue;
    const double angle = smallestComingAngle(run.mesh, run.scratch.change);
    if (angle <= best || judge(run.mesh, run.scratch.change, lenient(run)) != Verdict::Accepted)
      continue;
    best = angle;
    change = run.scratch.change;
  }
  if (best > kSliver) run.mesh.pin(apply(run.mesh, change));
}

}  // namespace

void reachTips(Run& run) {
  std::vector<Place> tips = farthestFirst(run);
  for (const Place& tip : tips) reach(run, tip);
  for (Place& tip : tips) {
    const double enough = kInsertAbove * run.asked.scale * run.sizes.at(tip.original);
    if (tip.distance <= enough) continue;
    measureAgain(run.mesh, tip);
    if (tip.distance > enough) insert(run, tip);
  }
}

}  // namespace remesher
