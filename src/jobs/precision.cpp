// SPDX-License-Identifier: MIT
#include "jobs/precision.h"

#include <utility>

#include "base/place.h"
#include "mesh/joining.h"

namespace remesher {

RoundedMesh inPrecisionOf(const TriangleMesh& original, TriangleMesh result) {
  const std::size_t places = countPlaces(result.positions);
  if (original.isSingle)
    for (Vec3& p : result.positions) p = inSingle(p, original.scale);
  result.isSingle = original.isSingle;
  joinNoise(result);
  const std::size_t left = countPlaces(result.positions);
  return {std::move(result), places - left};
}

}  // namespace remesher
