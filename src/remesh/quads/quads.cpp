// SPDX-License-Identifier: MIT
#include "remesh/quads/quads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "remesh/quads/base_meshes.h"
#include "remesh/quads/field/sectors.h"
#include "remesh/quads/field/singularities.h"
#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/quads/pair/pairing.h"
#include "remesh/quads/quad_sizes.h"
#include "remesh/quads/shape/chords.h"
#include "remesh/quads/shape/collapse.h"
#include "remesh/quads/shape/finish.h"
#include "remesh/quads/shape/quad_tips.h"
#include "remesh/quads/shape/rewiring.h"
#include "remesh/quads/shape/smoothing.h"

namespace remesher {

namespace {

// The map's triangles have so many vertices per vertex of the quads. At 10,000 quads, at 7
// neighboring counts, the horse's median distance is 0.36 % (hand: 0.32), with 0.5 0.40 (0.37);
// with 1 0.43 (0.35), in half as much time again, its worst 0.47, not 1.04 (0.43, not 0.55).
constexpr double kOfQuads = 0.7;
// But no fewer than this: fields and maps need so many to be smooth. With 2500 the bunny at 2000
// has a mean deviation of 7.9° and a distance of 1.38 %, not 6.1 and 0.91, medians of 7 counts.
constexpr std::size_t kLeastForMap = 5000;

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
std::size_t removeQuads(QuadMesh& mesh, const QuadGoal& goal, const WorkingMesh& ground) {
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

// Brings the count to the goal, or as near as allowed. Adding whole rows of quads makes no vertex
// irregular; removing single quads does.
void matchCount(MadeQuads& made, const QuadGoal& goal, const WorkingMesh& ground) {
  const double slack = goal.isExact ? 0 : kCountTolerance;
  const auto most = std::size_t(double(goal.vertices) * (1 + slack));
  const auto least = std::size_t(std::ceil(double(goal.vertices) * (1 - slack)));
  QuadMesh& mesh = made.mesh;
  const std::size_t before = mesh.vertices.size();
  const auto count = [&] { return wholeCount(mesh, goal.mirrors); };
  const auto own = [&](std::size_t whole) { return ownCount(whole, mesh, goal.mirrors); };
  if (count() < least) divideChords(mesh, ground, own(goal.vertices));
  if (count() < least) divideShortestChord(mesh, ground, own(least) - mesh.vertices.size());
  // Leaves room for vertices that rewiring may add.
  const std::size_t enough = count() > most ? (goal.vertices + most) / 2 : most;
  made.collapsed = removeQuads(mesh, {enough, goal.isExact, goal.mirrors}, ground);
  if (mesh.vertices.size() == before && made.collapsed == 0) return;
  settle(mesh, ground);
  const double faults = faultsOf(mesh, ground);
  if (faults == 0) return;
  MadeQuads rewired = made;
  rewire(rewired.mesh, ground);
  rewired.collapsed += removeQuads(rewired.mesh, {most, false, goal.mirrors}, ground);
  settle(rewired.mesh, ground);
  const std::size_t reached = wholeCount(rewired.mesh, goal.mirrors);
  if (reached < least || reached > most) return;
  if (faultsOf(rewired.mesh, ground) < faults) made = std::move(rewired);
}

// The share of a part in the vertices, by area or, where triangles are graded, by their number.
struct PartShare {
  std::size_t part;  // of the first mesh's
  Index number;      // of the original's connected part below
  double vertices;
};

std::vector<PartShare> sharesOf(const std::vector<WorkingMesh>& parts, double vertices,
                                bool isGraded) {
  const FaceData<Index> numbers = partNumbers(parts.front().surface().mesh());
  const auto weightOf = [&](const WorkingMesh& part) {
    return isGraded ? double(part.mesh().faceCount()) : areaOf(part);
  };
  double whole = 0;
  for (const WorkingMesh& part : parts) whole += weightOf(part);
  std::vector<PartShare> shares;
  for (std::size_t i = 0; i < parts.size(); ++i)
    shares.push_back(
        {i, numbers[parts[i].at(Vertex(0)).face], vertices * weightOf(parts[i]) / whole});
  return shares;
}

// The vertices that a mesh gets of the whole's, if all quads are squares of one size: of those on
// planes a half only is its own.
double ownVertices(const WorkingMesh& mesh, const QuadGoal& goal) {
  const auto images = double(std::size_t{1} << goal.mirrors.planes.size());
  const double length = std::sqrt(images * areaOf(mesh) / double(goal.vertices));
  const auto isOn = [&](Vertex v, const MirrorPlane& plane) {
    return std::abs(plane.distance(mesh.position(v))) <= goal.mirrors.slack;
  };
  double onPlanes = 0;
  for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); ++i) {
    const Vertex a = mesh.mesh().origin(Halfedge(i)), b = mesh.mesh().tip(Halfedge(i));
    for (const MirrorPlane& plane : goal.mirrors.planes)
      if (mesh.mesh().isBoundary(Halfedge(i)) && isOn(a, plane) && isOn(b, plane))
        onPlanes += (mesh.position(b) - mesh.position(a)).norm() / length;
  }
  return double(goal.vertices) / images + onPlanes / 2;
}

// The quads of a part, mapped on the first mesh from `level` on that has a map; no quads if no mesh
// has one. `level` becomes the mesh used, or the last mesh tried.
QuadMesh mapOn(BaseMeshes& bases, std::size_t& level, const PartShare& share, bool isGraded) {
  for (;; ++level) {
    const WorkingMesh* part = bases.part(level, share.number);
    if (!part) break;
    QuadMesh quads = mapToQuads(*part, share.vertices, isGraded ? gradedSizes : evenSizes);
    if (!quads.quads.empty()) return quads;
  }
  if (level > 0) --level;
  return {};
}

QuadMesh pairsOf(const WorkingMesh& mesh, double length) {
  const FaceFrames frames(mesh);
  return splitPairs(mesh, pairTriangles(mesh, frames, makeSmoothField(mesh, frames, length)));
}

// As many vertices as a triangle has that is divided into quads at its middle.
constexpr std::size_t kFewestOfPairs = 7;

// Makes quads by pairs, not yet shaped, of the parts that get too few vertices for fewer triangles
// to do; they leave the shares. What they take beyond theirs is taken from the others' shares.
QuadMesh pairTiny(std::vector<PartShare>& shares, const std::vector<WorkingMesh>& parts) {
  QuadMesh quads;
  std::vector<PartShare> others;
  double whole = 0, left = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    whole += shares[i].vertices;
    const bool isTiny =
        shares[i].vertices < kFewestOfPairs && parts[i].mesh().vertexCount() <= kFewestOfPairs;
    if (isTiny) {
      append(quads, pairsOf(parts[i], std::sqrt(areaOf(parts[i]) / shares[i].vertices)));
      continue;
    }
    left += shares[i].vertices;
    others.push_back(shares[i]);
  }
  const double rest = std::max(whole - double(quads.vertices.size()), left / 2);
  for (PartShare& share : others) share.vertices *= rest / left;
  shares = std::move(others);
  return quads;
}

// Makes quads by pairs, not yet shaped, for the parts with these numbers. How many triangles stay
// single is not known before: so the number of triangles is corrected, up to three meshes in all.
QuadMesh pairParts(const std::vector<PartShare>& wanted, std::size_t vertices,
                   const TriangleMaker& triangles) {
  double share = 0;
  for (const PartShare& one : wanted) share += one.vertices;
  std::size_t coarse = std::max<std::size_t>(vertices / 4, 4);
  QuadMesh quads;
  for (int i = 0; i < 3; ++i) {
    WorkingMesh mesh = triangles(coarse);
    openSectors(mesh);
    const FaceData<Index> numbers = partNumbers(mesh.surface().mesh());
    quads = {};
    for (const WorkingMesh& part : connectedParts(mesh)) {
      const Index number = numbers[part.at(Vertex(0)).face];
      const auto isIt = [&](const PartShare& one) { return one.number == number; };
      const auto found = std::find_if(wanted.begin(), wanted.end(), isIt);
      if (found == wanted.end()) continue;
      append(quads, pairsOf(part, std::sqrt(areaOf(part) / found->vertices)));
    }
    if (std::abs(double(quads.vertices.size()) / share - 1) <= kCountTolerance / 2) break;
    const double factor = share / double(quads.vertices.size());
    const auto next = std::size_t(std::max(4.0, std::round(double(coarse) * factor)));
    if (next == coarse) break;
    coarse = next;
  }
  return quads;
}

}  // namespace

QuadMesh pairToQuads(const WorkingMesh& mesh, double length) {
  QuadMesh quads = pairsOf(mesh, length);
  shape(quads, mesh);
  return quads;
}

std::size_t wholeCount(const QuadMesh& mesh, const Mirrors& mirrors) {
  std::size_t sum = 0;
  for (const Placement& place : mesh.vertices) {
    std::size_t images = std::size_t{1} << mirrors.planes.size();
    if (place.kind != VertexKind::Interior)
      for (const MirrorPlane& plane : mirrors.planes)
        if (std::abs(plane.distance(place.position)) <= mirrors.slack) images /= 2;
    sum += images;
  }
  return sum;
}

MadeQuads makeQuads(const QuadGoal& goal, const TriangleMaker& triangles) {
  const std::size_t least = kLeastForMap >> goal.mirrors.planes.size();
  const double dense = double(goal.vertices >> goal.mirrors.planes.size());
  BaseMeshes bases(triangles, std::max(std::size_t(dense * (goal.isDraft ? 0.5 : kOfQuads)), least),
                   std::size_t(dense));
  const double expected = ownVertices(bases.first(), goal);
  // Of each part: the mesh that its map is made on.
  std::vector<std::size_t> levels(bases.parts().size(), 0);
  const auto made = [&](double share) {
    const double vertices = share * expected;
    std::vector<PartShare> shares = sharesOf(bases.parts(), vertices, goal.isGraded), failed;
    MadeQuads result{pairTiny(shares, bases.parts()), bases.parts().size()};
    shape(result.mesh, bases.first());
    result.paired = result.parts - shares.size();
    for (const PartShare& one : shares) {
      const QuadMesh quads = mapOn(bases, levels[one.part], one, goal.isGraded);
      quads.quads.empty() ? failed.push_back(one) : append(result.mesh, quads);
    }
    result.paired += failed.size();
    if (!failed.empty()) {
      QuadMesh pairs = pairParts(failed, std::size_t(std::ceil(vertices)), triangles);
      shape(pairs, bases.first());
      append(result.mesh, pairs);
    }
    matchCount(result, goal, bases.first());
    return result;
  };
  // An exact number is reached by adding rows to a slightly smaller one, else by removing quads
  // from a slightly larger one. Of a half fewer numbers can be had: rows are added to several.
  std::vector<double> shares = {1};
  if (goal.isExact) shares = {1 - kCountTolerance, 1 + kCountTolerance};
  for (int i = 1; i < 4 && !goal.mirrors.planes.empty(); ++i)
    shares.push_back(1 - 3 * i * kCountTolerance);
  // Where rows are too long to be added, a larger number can be lessened quad by quad.
  const double above = 1 + 2 * kCountTolerance;
  if (goal.mirrors.planes.empty()) shares.push_back(above);
  const double slack = goal.isExact ? 0 : kCountTolerance * double(goal.vertices);
  const auto isOff = [&](const MadeQuads& one) {
    return std::abs(double(wholeCount(one.mesh, goal.mirrors)) - double(goal.vertices)) > slack;
  };
  // A missed number is worse than any pairs, and these than any number of quads taken out.
  const auto lackOf = [&](const MadeQuads& one) {
    return std::array{std::size_t{isOff(one)}, one.paired, one.collapsed};
  };
  std::optional<MadeQuads> best;
  for (const double share : shares) {
    // A part without a map at one share has none at others. The whole may, where its half has none.
    const bool isMet = best && !isOff(*best);
    if (isMet && (share == above || best->paired > 0 || best->collapsed == 0)) break;
    if (best && best->paired == best->parts && !goal.mirrors.planes.empty()) break;
    if (best && share == above && best->paired > 0) break;
    MadeQuads one = made(share);
    if (!best || lackOf(one) < lackOf(*best)) best = std::move(one);
  }
  if (!goal.isDraft) reachTips(best->mesh, bases.first(), kSmoothingSweeps);
  return std::move(*best);
}

}  // namespace remesher
