// SPDX-License-Identifier: MIT
#include "jobs/checks/crossing_check.h"

#include <algorithm>

#include "geometry/mesh_triangle.h"
#include "geometry/triangle_tree.h"
#include "jobs/checks/result_check.h"
#include "jobs/parts/part_places.h"
#include "measure/self_intersections.h"
#include "mesh/joining.h"
#include "mesh/submesh.h"

namespace remesher {
namespace {

Box boxOf(const TriangleMesh& mesh, Index triangle) {
  Box box;
  for (const Vec3& p : cornersOf(mesh, triangle)) box.extend(p);
  return box;
}

// A triangle's box, enlarged by its own size on all sides: there the original may have met itself
// for the result to meet itself here.
Box wideBox(const TriangleMesh& mesh, Index triangle) {
  const Box box = boxOf(mesh, triangle);
  const double size = (box.high - box.low).maxCoeff();
  return {box.low.array() - size, box.high.array() + size};
}

// The boxes of some triangles of a mesh.
using BoxOf = Box (*)(const TriangleMesh&, Index);
std::vector<Box> boxesOf(const TriangleMesh& mesh, const std::vector<Index>& triangles, BoxOf of) {
  std::vector<Box> boxes;
  for (const Index t : triangles) boxes.push_back(of(mesh, t));
  return boxes;
}

// The triangles of a mesh whose boxes overlap one of these, ascending.
std::vector<Index> trianglesNear(const TriangleMesh& mesh, BoxOf of,
                                 const std::vector<Box>& boxes) {
  std::vector<Vec3> ends;
  std::vector<Index> diagonals;  // as triangles: their boxes are these
  for (const Box& box : boxes) {
    diagonals.insert(diagonals.end(), 2, Index(ends.size()));
    diagonals.push_back(Index(ends.size() + 1));
    ends.insert(ends.end(), {box.low, box.high});
  }
  const TriangleTree tree(ends, diagonals);
  std::vector<Index> found;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
    tree.visitOverlapping(of(mesh, t), [&](Index) {
      if (found.empty() || found.back() != t) found.push_back(t);
    });
  return found;
}

double volumeOf(const Box& box) { return (box.high - box.low).prod(); }

// Whether boxes take so much of a mesh's that most of its triangles are near several of them.
bool areLarge(const std::vector<Box>& boxes, const TriangleMesh& mesh) {
  constexpr double kMostShare = 4;
  Box whole;
  for (const Vec3& p : mesh.positions) whole.extend(p);
  double sum = 0;
  for (const Box& box : boxes) sum += volumeOf(box);
  return !(sum < kMostShare * volumeOf(whole));
}

// Of a mesh all triangles that may be near one of these boxes and meet another triangle, and those
// that they may meet.
TriangleMesh meetingNear(const TriangleMesh& mesh, const std::vector<Box>& boxes) {
  if (areLarge(boxes, mesh)) return mesh;
  const std::vector<Index> near = trianglesNear(mesh, boxOf, boxes);
  return submeshOf(mesh, trianglesNear(mesh, boxOf, boxesOf(mesh, near, boxOf))).mesh;
}

// Without those of the triangles `found` that are near one of the original's `given`.
std::vector<Index> beyond(const TriangleMesh& original, const std::vector<Index>& given,
                          const TriangleMesh& result, std::vector<Index> found) {
  if (given.empty()) return found;
  const std::vector<Index> near = trianglesNear(result, wideBox, boxesOf(original, given, boxOf));
  std::erase_if(found, [&](Index t) { return std::binary_search(near.begin(), near.end(), t); });
  return found;
}

// All parts at their places, each a group.
struct Assembly {
  TriangleMesh mesh;
  std::vector<std::size_t> parts;  // per group
  std::vector<Index> firsts;       // per group, the first vertex
};

Assembly assembled(const std::vector<io::Part>& parts, const std::vector<PartPlace>& places) {
  Assembly all{gathered(parts, places), {}, {}};
  std::vector<Index> groupOf;  // per vertex
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i].finer.empty()) continue;
    all.firsts.push_back(Index(groupOf.size()));
    groupOf.resize(groupOf.size() + parts[i].mesh.positions.size(), Index(all.parts.size()));
    all.parts.push_back(i);
  }
  for (std::size_t i = 0; i + 2 < all.mesh.indices.size(); i += 3)
    all.mesh.groups.push_back(groupOf[all.mesh.indices[i]]);
  return all;
}

}  // namespace

std::vector<Index> crossingsMade(const TriangleMesh& original, const TriangleMesh& result,
                                 bool* isCrossed) {
  std::vector<Index> found = selfIntersections(result);
  if (found.empty()) return found;
  const TriangleMesh near = meetingNear(original, boxesOf(result, found, wideBox));
  const std::vector<Index> given = selfIntersections(near);
  if (isCrossed != nullptr) *isCrossed = !given.empty() || !selfIntersections(original).empty();
  return beyond(near, given, result, std::move(found));
}

MadeCrossings crossingsMade(const PartPairs& parts, const std::vector<std::vector<Index>>& own) {
  MadeCrossings made;
  const auto add = [&](std::size_t count, std::size_t part, Index vertex) {
    if (made.count == 0 && count > 0) made.part = part, made.vertex = vertex;
    made.count += count;
  };
  for (std::size_t i = 0; i < own.size(); ++i)
    if (!own[i].empty())
      add(own[i].size(), i, parts.results[i].mesh.indices[std::size_t{3} * own[i].front()]);
  if (parts.results.size() < 2) return made;
  Assembly result = assembled(parts.results, parts.places);
  if (intersectionsOfGroups(result.mesh).empty()) return made;
  // Where parts share a border, each is rounded in its own space.
  joinNear(result.mesh, kSingleRoundOff * diagonalOf(result.mesh));
  std::vector<Index> found = intersectionsOfGroups(result.mesh);
  if (found.empty()) return made;
  const TriangleMesh original = assembled(parts.originals, parts.places).mesh;
  found = beyond(original, intersectionsOfGroups(original), result.mesh, std::move(found));
  if (found.empty()) return made;
  const Index group = result.mesh.groups[found.front()];
  add(found.size(), result.parts[group],
      result.mesh.indices[std::size_t{3} * found.front()] - result.firsts[group]);
  return made;
}

std::vector<Warning> warningsOf(const MadeCrossings& made, const std::vector<io::Part>& result) {
  if (made.count == 0) return {};
  const io::Part& part = result[made.part];
  const Vec3 place = inWorldOf(part, part.mesh.positions[made.vertex]);
  return {{"SELF_INTERSECTIONS_MADE",
           "Triangles of the result intersect others where the input's do not, for example near (" +
               placeInWords(place, result) + ").",
           made.count, place}};
}

}  // namespace remesher
