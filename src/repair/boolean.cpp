// SPDX-License-Identifier: MIT
#include "repair/boolean.h"

#include <utility>
#include <vector>

#include "repair/exact_repair.h"
#include "repair/stitch.h"

namespace remesher {

std::optional<United> booleanOf(const TriangleMesh& both, std::size_t trianglesOfA,
                                BooleanOperation operation) {
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
                    }};
  for (std::size_t t = 0; t < trianglesOfA; ++t) operands.numbers[t] = 0;
  std::optional<United> result = arranged(atOnePosition(both), operands);
  if (result && countUnbalancedEdges(result->mesh) > 0) return std::nullopt;
  return result;
}

}  // namespace remesher
