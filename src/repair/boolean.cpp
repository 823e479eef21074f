// SPDX-License-Identifier: MIT
#include "repair/boolean.h"

#include <utility>
#include <vector>

#include "geometry/triangle_tree.h"
#include "repair/exact_repair.h"
#include "repair/stitch.h"

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
  if (each == Each::Sound) operands.meeting = nearOther(both, trianglesOfA);
  std::optional<United> result = arranged(atOnePosition(both), operands);
  if (result && countUnbalancedEdges(result->mesh) > 0) return std::nullopt;
  return result;
}

}  // namespace remesher
