// SPDX-License-Identifier: MIT
// The union, difference and intersection of two bodies, and the report of how they were found.
#pragma once

#include <cstddef>

namespace remesher {

enum class BooleanOperation { Union, Subtract, Intersect };

struct BooleanReport {
  BooleanOperation operation = BooleanOperation::Union;
  std::size_t cut = 0;                // triangles of both operands that met others
  std::size_t selfIntersections = 0;  // triangles of the result that rounding left meeting others
};

}  // namespace remesher
