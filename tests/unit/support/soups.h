// SPDX-License-Identifier: MIT
// Bags of triangles for whatever must take any of them: with repeated corners at every triangle,
// in generic position, or placed to a plan. Deterministic.
#pragma once

#include <cstdint>
#include <initializer_list>

#include "base/triangle_mesh.h"

namespace remesher::soups {

// Numbers in [0, 1), the same ones for the same seed [Marsaglia, Xorshift RNGs].
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 1) {}

  double number() {
    state_ ^= state_ << 13, state_ ^= state_ >> 7, state_ ^= state_ << 17;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  Vec3 point() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

 private:
  std::uint64_t state_;
};

inline void addTriangle(TriangleMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
  for (const Vec3& p : {a, b, c}) {
    mesh.indices.push_back(static_cast<Index>(mesh.positions.size()));
    mesh.positions.push_back(p);
  }
}

struct Quad {
  Vec3 a, b, c, d;
};

inline void addQuad(TriangleMesh& mesh, const Quad& quad) {
  addTriangle(mesh, quad.a, quad.b, quad.c);
  addTriangle(mesh, quad.a, quad.c, quad.d);
}

inline TriangleMesh joined(std::initializer_list<TriangleMesh> meshes) {
  TriangleMesh result;
  for (const TriangleMesh& mesh : meshes) {
    const Index offset = static_cast<Index>(result.positions.size());
    for (const Vec3& p : mesh.positions) result.positions.push_back(p);
    for (const Index v : mesh.indices) result.indices.push_back(offset + v);
  }
  return result;
}

inline TriangleMesh moved(TriangleMesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.positions) p += by;
  return mesh;
}

// Small triangles anywhere in the unit cube.
inline TriangleMesh randomSoup(std::size_t triangles, double size, std::uint64_t seed) {
  Random random(seed);
  TriangleMesh mesh;
  for (std::size_t t = 0; t < triangles; ++t) {
    const Vec3 at = random.point();
    const Vec3 a = random.point(), b = random.point(), c = random.point();
    addTriangle(mesh, at + size * a, at + size * b, at + size * c);
  }
  return mesh;
}

// The cube from `low` to `high` along each axis: each face two triangles.
inline TriangleMesh cube(double low, double high) {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const double level : {low, high}) {
      const auto corner = [&](double u, double v) {
        Vec3 p;
        p[axis] = level, p[(axis + 1) % 3] = u, p[(axis + 2) % 3] = v;
        return p;
      };
      const double from = level == high ? low : high, to = level == high ? high : low;
      addQuad(mesh, {corner(from, low), corner(to, low), corner(to, high), corner(from, high)});
    }
  return mesh;
}

// The unit square in the plane z = 0, n × n cells of two triangles.
inline TriangleMesh square(int n) {
  TriangleMesh mesh;
  const double step = 1.0 / n;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const double x = i * step, y = k * step, x2 = (i + 1) * step, y2 = (k + 1) * step;
      addQuad(mesh, {{x, y, 0}, {x2, y, 0}, {x2, y2, 0}, {x, y2, 0}});
    }
  return mesh;
}

// The unit sphere: each face of an octahedron n × n triangles.
inline TriangleMesh sphere(int n) {
  TriangleMesh mesh;
  const auto face = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto at = [&](int i, int k) -> Vec3 {
      return (double(n - i - k) * a + double(i) * b + double(k) * c).normalized();
    };
    for (int i = 0; i < n; ++i)
      for (int k = 0; i + k < n; ++k) {
        addTriangle(mesh, at(i, k), at(i + 1, k), at(i, k + 1));
        if (i + k + 1 < n) addTriangle(mesh, at(i + 1, k), at(i + 1, k + 1), at(i, k + 1));
      }
  };
  for (const double z : {1.0, -1.0})
    for (const double y : {1.0, -1.0})
      for (const double x : {1.0, -1.0}) {
        const Vec3 ex(x, 0, 0), ey(0, y, 0), ez(0, 0, z);
        x* y* z > 0 ? face(ex, ey, ez) : face(ey, ex, ez);
      }
  return mesh;
}

}  // namespace remesher::soups
