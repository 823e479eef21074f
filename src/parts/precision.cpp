// SPDX-License-Identifier: MIT
#include "parts/precision.h"

#include <utility>

#include "measure/edge_table.h"

namespace remesher {

RoundedMesh inPrecisionOf(const TriangleMesh& original, TriangleMesh result) {
  if (!original.isSingle) return {std::move(result)};
  const std::size_t places = weld(result).positions.size();
  for (Vec3& p : result.positions) p = inSingle(p, original.scale);
  result.isSingle = true;
  const std::size_t left = weld(result).positions.size();
  return {std::move(result), places - left};
}

}  // namespace remesher
