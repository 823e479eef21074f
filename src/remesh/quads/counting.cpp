// SPDX-License-Identifier: MIT
#include "remesh/quads/counting.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "remesh/quads/quads.h"
#include "remesh/quads/shape/chords.h"
#include "remesh/quads/shape/collapse.h"
#include "remesh/quads/shape/finish.h"
#include "remesh/quads/shape/rewiring.h"

namespace remesher {

namespace {

// The mesh's own number of vertices that makes so many of the whole, if what is added or removed is
// on no plane.
std::size_t ownCount(std::size_t whole, const QuadMesh& mesh, const Mirrors& mirrors) {
  const std::size_t now = wholeCount(mesh, mirrors), own = mesh.vertices.size();
  const std::size_t images = std::size_t{1} << mirrors.planes.size();
  if (whole >= now) return own + (whole - now) / images;
  return own - std::min(own, (now - whole + images - 1) / images);
}

// Removes single quads. Of a half this takes several rounds, for not all vertices have the same
// number of images. To reach an exact number quads may fold; if it is missed all the same, the mesh
// is restored, and quads go without folds.
std::size_t removeQuads(QuadMesh& mesh, const CountGoal& goal, const WorkingMesh& ground) {
  std::optional<QuadMesh> before;
  if (goal.isExact) before = mesh;
  std::size_t removed = 0, now = 1;
  while (now > 0 && (removed == 0 || wholeCount(mesh, goal.mirrors) > goal.vertices)) {
    const std::size_t own = ownCount(goal.vertices, mesh, goal.mirrors);
    now = collapseTo(mesh, ground, {std::max<std::size_t>(own, 8), goal.isExact});
    removed += now;
  }
  if (before && wholeCount(mesh, goal.mirrors) != goal.vertices) {
    mesh = std::move(*before);
    return removeQuads(mesh, {goal.vertices, false, goal.mirrors}, ground);
  }
  return removed;
}

// Rows up to the number; if fewer than `least` vertices result, one row more where that comes
// nearer, or where the number is too far off without.
void addRows(QuadMesh& mesh, const CountGoal& goal, const WorkingMesh& ground, std::size_t least) {
  const auto own = [&](std::size_t whole) { return ownCount(whole, mesh, goal.mirrors); };
  if (wholeCount(mesh, goal.mirrors) >= least) return;
  divideChords(mesh, ground, own(goal.vertices));
  const std::size_t now = wholeCount(mesh, goal.mirrors);
  if (now >= least) return;
  QuadMesh longer = mesh;
  divideShortestChord(longer, ground, own(least) - mesh.vertices.size());
  const std::size_t then = wholeCount(longer, goal.mirrors);
  const bool isNearer = then < goal.vertices + (goal.vertices - now);
  if (goal.isExact || isNearer || !goal.isFree(now)) mesh = std::move(longer);
}

}  // namespace

bool CountGoal::isFree(std::size_t count) const {
  return std::abs(double(count) - double(vertices)) <= free * double(vertices);
}

std::size_t matchCount(QuadMesh& mesh, const CountGoal& goal, const WorkingMesh& ground,
                       WorkBudget& work) {
  const double slack = goal.isExact ? 0 : kCountTolerance;
  const auto most = std::size_t(double(goal.vertices) * (1 + slack));
  const auto least = std::size_t(std::ceil(double(goal.vertices) * (1 - slack)));
  const std::size_t before = mesh.vertices.size();
  addRows(mesh, goal, ground, least);
  std::size_t removed = 0, now = wholeCount(mesh, goal.mirrors);
  const bool isFree = !goal.isExact && goal.isFree(now);
  if (!isFree && now > most) {
    // Leaves room for vertices that rewiring may add.
    const std::size_t enough = (goal.vertices + most) / 2;
    removed = removeQuads(mesh, {enough, goal.isExact, goal.mirrors}, ground);
  }
  if (mesh.vertices.size() == before && removed == 0) return 0;
  settle(mesh, ground);
  const double faults = faultsOf(mesh, ground);
  if (faults == 0) return removed;
  QuadMesh rewired = mesh;
  rewire(rewired, ground, work);
  const auto isMet = [&] {
    now = wholeCount(rewired, goal.mirrors);
    return (now >= least && now <= most) || (isFree && goal.isFree(now));
  };
  std::size_t more = 0;
  if (!isMet() && now > most) more = removeQuads(rewired, {most, false, goal.mirrors}, ground);
  settle(rewired, ground);
  if (!isMet() || !(faultsOf(rewired, ground) < faults)) return removed;
  mesh = std::move(rewired);
  return removed + more;
}

}  // namespace remesher
