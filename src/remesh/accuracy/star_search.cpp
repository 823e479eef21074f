// SPDX-License-Identifier: MIT
#include "remesh/accuracy/star_search.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/pattern_search.h"
#include "geometry/triangle.h"
#include "original/surface/surface_walk.h"
#include "remesh/accuracy/narrowest.h"
#include "remesh/operators/smoothing.h"
#include "remesh/steps/sweeps.h"

namespace remesher {

namespace {

constexpr std::size_t kAlongNormal = 2;

// First up and down the star's mean normal, then around it.
std::vector<Vec3> directionsAt(const WorkingMesh& mesh, Vertex v) {
  const HalfedgeMesh& m = mesh.mesh();
  const Vec3 normal = mesh.areaVectorAround(v).normalized();
  const Vec3 spoke = mesh.position(m.tip(m.outgoing(v))) - mesh.position(v);
  const Vec3 x = (spoke - normal * normal.dot(spoke)).normalized(), y = normal.cross(x);
  std::vector<Vec3> directions = {0.5 * normal, -0.5 * normal};
  for (const Vec2& way : planeDirections()) directions.push_back(way.x() * x + way.y() * y);
  return directions;
}

// Whether a triangle around v would turn by more than a right angle.
bool turnsOver(const WorkingMesh& mesh, Vertex v, const Vec3& to) {
  bool found = false;
  mesh.mesh().forEachOutgoing(v, [&](Halfedge h) {
    const Vec3 &a = mesh.position(mesh.mesh().tip(h)), &b = mesh.position(mesh.mesh().opposite(h));
    found = found || unitNormal(mesh.position(v), a, b).dot(unitNormal(to, a, b)) < 0;
  });
  return found;
}

}  // namespace

StarSearch::StarSearch(const Run& run, const Crossings& crossings, TwoSidedDistance& distances,
                       const Movable& movable)
    : run_(run),
      mesh_(run.mesh),
      rule_(lenient(run)),
      crossings_(crossings),
      distances_(distances),
      v_(movable.vertex),
      spoke_(mesh_.meanSpoke(v_)),
      best_(mesh_.placement(v_)),
      distance_(distances.around(v_, best_)),
      lowest_(std::min(movable.keepAngle, narrowestAround(run, v_, best_.position))) {}

bool StarSearch::isAllowed(const Placement& place) {
  if (turnsOver(mesh_, v_, place.position)) return false;
  proposePlacement(mesh_, v_, place, change_);
  return judge(mesh_, change_, rule_) == Verdict::Accepted &&
         !(looksForCrossings_ && crossings_.grow(change_));
}

bool StarSearch::crosses() {
  proposePlacement(mesh_, v_, best_, change_);
  return crossings_.grow(change_);
}

bool StarSearch::keepsAngles(const Vec3& position) const {
  return narrowestAround(run_, v_, position) >= lowest_;
}

bool StarSearch::offer(const Placement& place) {
  const double distance = distances_.around(v_, place, distance_);
  if (distance >= distance_ || !isAllowed(place)) return false;
  distance_ = distance;
  best_ = place;
  return true;
}

Placement StarSearch::at(const Vec3& position) const {
  Placement place = mesh_.onSurface(closestPointFrom(mesh_.surface(), best_.at, position));
  if (!mesh_.surface().isFlatAt(place.at)) place.position = position;
  return place;
}

// look: offers places a step away and returns whether one was better.
template <typename Look>
void StarSearch::search(const Look& look) {
  searchPattern([&](double step) { return look(step * spoke_); });
}

void StarSearch::move(std::span<const Vec3> directions) {
  search([&](double step) {
    bool better = false;
    const Vec3 from = best_.position;
    for (const Vec3& direction : directions) {
      const Vec3 to = from + step * direction;
      if (!keepsAngles(to)) continue;
      const Placement place = at(to);
      const bool isThere = place.position == to || keepsAngles(place.position);
      better = (isThere && offer(place)) || better;
    }
    return better;
  });
}

// Stays between the neighbours along the curve: beyond them the curve would turn back.
void StarSearch::slide() {
  const auto [before, after] = curveNeighbors(mesh_, v_);
  for (const Vertex end : {before, after})  // quads do not follow every curve
    if (!end || mesh_.kind(end) == VertexKind::Interior) return;
  const Index chain = best_.on.chain;
  const auto ends =
      std::minmax({mesh_.onChain(before, chain).arc, mesh_.onChain(after, chain).arc});
  const double room = kRoom * (ends.second - ends.first);
  search([&](double step) {
    bool better = false;
    const double from = best_.on.arc;
    for (const double arc : {from + step, from - step}) {
      if (arc <= ends.first + room || arc >= ends.second - room) continue;
      const Placement place = mesh_.onCurve({chain, arc});
      better = (keepsAngles(place.position) && offer(place)) || better;
    }
    return better;
  });
}

void StarSearch::lookAround() {
  if (best_.kind == VertexKind::Curve) return slide();
  const std::vector<Vec3> directions = directionsAt(mesh_, v_);
  // Moves along the normal cost no angles; in a plane they lead nowhere.
  const bool isFlat = mesh_.surface().isFlatAt(best_.at);
  if (!isFlat) move(std::span(directions).first(kAlongNormal));
  move(std::span(directions).subspan(isFlat ? kAlongNormal : 0));
}

// Triangles seldom come to pass through others, and a test for this takes longer than all else. So
// a search tests once, at the place that it has found. Only if triangles cross there does it begin
// again and test every place.
void StarSearch::descend() {
  const Placement before = best_;
  const double distance = distance_;
  lookAround();
  if (distance_ == distance || !crosses()) return;
  best_ = before;
  distance_ = distance;
  looksForCrossings_ = true;
  lookAround();
}

}  // namespace remesher
