// SPDX-License-Identifier: MIT
#include "repair/boolean.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "base/fires.h"
#include "geometry/box.h"
#include "repair/exact_repair.h"
#include "repair/touching_faces.h"

namespace remesher {

namespace {

Box boxOf(const TriangleMesh& mesh, std::size_t from, std::size_t end) {
  Box box;
  for (std::size_t i = 3 * from; i < 3 * end; ++i) box.extend(mesh.positions[mesh.indices[i]]);
  return box;
}

// The triangles of each operand that reach into the box around the other.
std::vector<Index> nearOther(const TriangleMesh& both, std::size_t trianglesOfA) {
  const std::size_t count = both.triangleCount();
  const Box boxA = boxOf(both, 0, trianglesOfA), boxB = boxOf(both, trianglesOfA, count);
  std::vector<Index> near;
  for (Index t = 0; t < count; ++t)
    if (boxOf(both, t, t + 1).overlaps(t < trianglesOfA ? boxB : boxA)) near.push_back(t);
  return near;
}

// The operands that triangles with such parents belong to.
std::vector<Index> numbersOf(const std::vector<Index>& parents, std::span<const Index> numbers) {
  std::vector<Index> own;
  for (const Index parent : parents) own.push_back(numbers[parent]);
  return own;
}

// The second operand's triangles, turned over.
void turnSecond(TriangleMesh& both, std::span<const Index> numbers) {
  for (std::size_t t = 0; t < numbers.size(); ++t)
    if (numbers[t] == 1) std::swap(both.indices[3 * t + 1], both.indices[3 * t + 2]);
}

// Both with common triangles where their faces lie on each other, facing opposite ways or the same
// way: then the second is turned over, so that they touch.
JoinedFaces withCommonFaces(const TriangleMesh& both, std::span<const Index> numbers,
                            double steps) {
  JoinedFaces joined{both, std::vector<Index>(both.triangleCount())};
  std::iota(joined.parents.begin(), joined.parents.end(), Index{0});
  for (int turn = 0; turn < 2; ++turn) {
    if (auto next = withFacesJoined(joined.mesh, steps, SharedFaces::Kept)) {
      for (Index& parent : next->parents) parent = joined.parents[parent];
      joined = std::move(*next);
    }
    turnSecond(joined.mesh, numbersOf(joined.parents, numbers));
  }
  return joined;
}

// The result of operands whose faces were brought together, if it has fewer defects.
void joinFaces(const TriangleMesh& both, const Operands& operands, United& result, Defects fewest) {
  for (const double steps : {4.0, 32.0}) {
    if (fewest == Defects{}) return;
    const JoinedFaces joined = withCommonFaces(both, operands.numbers, steps);
    if (joined.mesh.indices == both.indices) continue;
    std::optional<United> other =
        arranged(joined.mesh, {numbersOf(joined.parents, operands.numbers), operands.isInside, {}});
    if (!other) continue;
    const Defects defects = defectsOf(*other);
    if (defects >= fewest) continue;
    fewest = defects;
    fires("boolean: touching faces joined");
    for (Index& parent : other->parents) parent = joined.parents[parent];
    other->cut = std::max(other->cut, result.cut);
    result = std::move(*other);
  }
}

}  // namespace

std::optional<United> booleanOf(const TriangleMesh& both, std::size_t trianglesOfA,
                                BooleanOperation operation, Each each) {
  Operands operands{std::vector<Index>(both.triangleCount(), 1),
                    [operation](std::span<const int> windings) {
                      const bool isInA = windings[0] > 0, isInB = windings[1] > 0;
                      switch (operation) {
                        case BooleanOperation::Union:
                          return isInA || isInB;
                        case BooleanOperation::Subtract:
                          return isInA && !isInB;
                        default:
                          return isInA && isInB;
                      }
                    },
                    {}};
  for (std::size_t t = 0; t < trianglesOfA; ++t) operands.numbers[t] = 0;
  const TriangleMesh mesh = atOnePosition(both);
  if (each == Each::Sound) {
    operands.known = {nearOther(both, trianglesOfA), mesh.positions == both.positions};
  }
  std::optional<United> result = arranged(mesh, operands);
  if (!result) return std::nullopt;
  const Defects defects = defectsOf(*result);
  if (defects.unbalanced > 0) return std::nullopt;
  joinFaces(mesh, operands, *result, defects);
  return result;
}

}  // namespace remesher
