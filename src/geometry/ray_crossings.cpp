// SPDX-License-Identifier: MIT
#include "geometry/ray_crossings.h"

#include "geometry/predicates.h"

namespace remesher {

namespace {

// The side of the line from a to b, in the yz plane, on which p lies when it is moved by ε along y
// and by ε² along z. Never 0 unless a and b coincide there.
int sideOfMoved(const Vec2& a, const Vec2& b, const Vec2& p) {
  if (const int side = orient2d(a, b, p); side != 0) return side;
  if (a.y() != b.y()) return a.y() > b.y() ? 1 : -1;
  return a.x() < b.x() ? 1 : a.x() > b.x() ? -1 : 0;
}

// Which way the triangle faces where the moved line through p crosses it; 0 if it does not.
int facingAt(const Vec3& p, const Triangle& t) {
  const auto flat = [](const Vec3& q) { return Vec2(q.y(), q.z()); };
  const Vec2 a = flat(t[0]), b = flat(t[1]), c = flat(t[2]), q = flat(p);
  const int facing = sideOfMoved(a, b, q);
  return sideOfMoved(b, c, q) == facing && sideOfMoved(c, a, q) == facing ? facing : 0;
}

}  // namespace

int rayCrossing(const Vec3& p, const Triangle& t) {
  const int facing = facingAt(p, t);
  if (facing == 0) return 0;
  // The ray meets the triangle if p lies behind a triangle that faces +x, or before one that
  // faces -x.
  return orient3d(t[0], t[1], t[2], p) == facing ? facing : 0;
}

int lineCrossing(const Vec3& p, const Triangle& t) {
  const int facing = facingAt(p, t);
  return facing == 0 ? 0 : facing * orient3d(t[0], t[1], t[2], p);
}

}  // namespace remesher
