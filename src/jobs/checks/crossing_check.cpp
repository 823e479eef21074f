// SPDX-License-Identifier: MIT
#include "jobs/checks/crossing_check.h"

#include <algorithm>

#include "geometry/mesh_triangle.h"
#include "geometry/triangle_tree.h"
#include "jobs/checks/result_check.h"
#include "measure/self_intersections.h"
#include "mesh/joining.h"

namespace remesher {
namespace {

// A triangle's box, enlarged by its own size on all sides: there the original may have met itself
// for the result to meet itself here.
Box wideBox(const TriangleMesh& mesh, Index triangle) {
  Box box;
  for (const Vec3& p : cornersOf(mesh, triangle)) box.extend(p);
  const double size = (box.high - box.low).maxCoeff();
  return {box.low.array() - size, box.high.array() + size};
}

// Without those of the triangles `found` that are near one of the original's `given`.
std::vector<Index> beyond(const TriangleMesh& original, const std::vector<Index>& given,
                          const TriangleMesh& result, std::vector<Index> found) {
  if (given.empty()) return found;
  std::vector<Index> corners;
  for (const Index t : given)
    for (std::size_t k = 0; k < 3; ++k) corners.push_back(original.indices[std::size_t{3} * t + k]);
  const TriangleTree tree(original.positions, corners);
  std::erase_if(found, [&](Index t) {
    bool isNear = false;
    tree.visitOverlapping(wideBox(result, t), [&](Index) { isNear = true; });
    return isNear;
  });
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
  const std::vector<Index> given = selfIntersections(original);
  if (isCrossed != nullptr) *isCrossed = !given.empty();
  return beyond(original, given, result, std::move(found));
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
  const Vec3& place = result[made.part].mesh.positions[made.vertex];
  return {{"SELF_INTERSECTIONS_MADE",
           "Triangles of the result intersect others where the input's do not, for example near (" +
               placeInWords(place, result) + ").",
           made.count, place}};
}

}  // namespace remesher
