// SPDX-License-Identifier: MIT
#include "geometry/quad.h"

namespace remesher {

Vec3 areaVector(const Quad& corners) {
  return 0.5 * (corners[2] - corners[0]).cross(corners[3] - corners[1]);
}

std::array<double, 4> cornerSines(const Quad& corners, const Vec3& normal) {
  std::array<double, 4> sines{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 out = corners[(i + 1) % 4] - corners[i], in = corners[(i + 3) % 4] - corners[i];
    const double lengths = out.norm() * in.norm();
    sines[i] = lengths > 0 ? out.cross(in).dot(normal) / lengths : 0;
  }
  return sines;
}

// In a square a quarter turn maps the vector from the centre to a corner onto the next corner's
// vector: so the four vectors are turned back to one direction and averaged.
Quad fittedSquare(const Quad& corners) {
  const Vec3 centre = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
  const Vec3 normal = areaVector(corners).normalized();
  const Vec3 even = (corners[0] - corners[2]) / 4, odd = (corners[1] - corners[3]) / 4;
  Vec3 way = even - normal.cross(odd);
  way -= way.dot(normal) * normal;
  const Vec3 next = normal.cross(way);
  return {centre + way, centre + next, centre - way, centre - next};
}

}  // namespace remesher
