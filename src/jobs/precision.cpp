// SPDX-License-Identifier: MIT
#include "jobs/precision.h"

#include <utility>

#include "base/place.h"

namespace remesher {

RoundedMesh inPrecisionOf(const TriangleMesh& original, TriangleMesh result) {
  if (!original.isSingle) return {std::move(result)};
  const std::size_t places = countPlaces(result.positions);
  for (Vec3& p : result.positions) p = inSingle(p, original.scale);
  result.isSingle = true;
  const std::size_t left = countPlaces(result.positions);
  return {std::move(result), places - left};
}

}  // namespace remesher
