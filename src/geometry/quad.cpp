// SPDX-License-Identifier: MIT
#include "geometry/quad.h"

#include <algorithm>

namespace remesher {

Vec3 areaVector(const Quad& corners) {
  return 0.5 * (corners[2] - corners[0]).cross(corners[3] - corners[1]);
}

Quad cornerNormals(const Quad& corners) {
  Quad sides, normals;
  std::array<double, 4> lengths{};
  for (std::size_t i = 0; i < 4; ++i) {
    sides[i] = corners[(i + 1) % 4] - corners[i];
    lengths[i] = sides[i].norm();
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t before = (i + 3) % 4;
    const double product = lengths[before] * lengths[i];
    normals[i] = product > 0 ? Vec3(sides[before].cross(sides[i]) / product) : Vec3(Vec3::Zero());
  }
  return normals;
}

double leastSine(const Quad& cornerNormals, const Vec3& normal) {
  double least = 1;
  for (const Vec3& corner : cornerNormals) least = std::min(least, corner.dot(normal));
  return least;
}

// In a square a quarter turn maps the vector from the centre to a corner onto the next corner's
// vector: so the four vectors are turned back to one direction and averaged. Of the nearest
// rectangle the diagonals keep their directions and have their mean length.
Quad fittedRectangle(const Quad& corners, double squareness) {
  const Vec3 centre = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
  const Vec3 normal = areaVector(corners).normalized();
  const Vec3 even = (corners[0] - corners[2]) / 2, odd = (corners[1] - corners[3]) / 2;
  Vec3 way = (even - normal.cross(odd)) / 2;
  way -= way.dot(normal) * normal;
  const Vec3 next = normal.cross(way);
  const double length = (even.norm() + odd.norm()) / 2;
  const Vec3 p = squareness * way + (1 - squareness) * length * even.normalized();
  const Vec3 q = squareness * next + (1 - squareness) * length * odd.normalized();
  return {centre + p, centre + q, centre - p, centre - q};
}

}  // namespace remesher
