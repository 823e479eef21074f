// SPDX-License-Identifier: MIT
// Small surfaces to grow and map patches on.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher::patch_shapes {

struct Shape {
  std::string name;
  HalfedgeMesh mesh;
  VertexData<Vec3> positions;
};

inline Shape makeShape(const std::string& name, const std::vector<Vec3>& points,
                       const std::vector<Index>& triangles) {
  Shape shape{name, HalfedgeMesh(points.size(), triangles), {}};
  shape.positions.values() = points;
  return shape;
}

inline Shape triangle() {
  return makeShape("triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2});
}

inline Shape tetrahedron() {
  return makeShape("tetrahedron", {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                   {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2});
}

inline Shape cube() {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  return makeShape("cube", points, {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                    2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5});
}

// n × n squares of side 1 in the plane z = 0.
inline Shape grid(int n) {
  std::vector<Vec3> points;
  std::vector<Index> triangles;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) points.push_back({double(x), double(y), 0});
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const Index a = Index(y * (n + 1) + x), b = a + 1, c = a + Index(n) + 1, d = c + 1;
      triangles.insert(triangles.end(), {a, b, d, a, d, c});
    }
  }
  return makeShape("grid", points, triangles);
}

inline Shape icosphere(int levels) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  std::vector<Vec3> points = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                              {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                              {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  std::vector<Index> faces = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                              4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                              6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [at, isNew] = middles.insert({std::minmax(a, b), Index(points.size())});
      if (isNew) points.push_back((points[a] + points[b]) / 2);
      return at->second;
    };
    std::vector<Index> finer;
    for (std::size_t t = 0; t < faces.size(); t += 3) {
      const Index a = faces[t], b = faces[t + 1], c = faces[t + 2];
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
    }
    faces = finer;
  }
  for (Vec3& p : points) p.normalize();
  return makeShape("icosphere", points, faces);
}

// A quad grid closed in both directions (torus) or in one (tube: height 3, open at both ends).
inline Shape torus(int around, int across) {
  std::vector<Vec3> points;
  std::vector<Index> triangles;
  const auto id = [&](int i, int j) { return Index((i % around) * across + j % across); };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double r = 3 + std::cos(v);
      points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
      const Index a = id(i, j), b = id(i + 1, j), c = id(i, j + 1), d = id(i + 1, j + 1);
      triangles.insert(triangles.end(), {a, b, d, a, d, c});
    }
  }
  return makeShape("torus", points, triangles);
}

inline Shape tube(int around, int along) {
  std::vector<Vec3> points;
  std::vector<Index> triangles;
  for (int j = 0; j <= along; ++j) {
    for (int i = 0; i < around; ++i) {
      const double u = 2 * std::numbers::pi * i / around;
      points.push_back({std::cos(u), std::sin(u), 3.0 * j / along});
      if (j == along) continue;
      const Index a = Index(j * around + i), b = Index(j * around + (i + 1) % around);
      const Index c = a + Index(around), d = b + Index(around);
      triangles.insert(triangles.end(), {a, b, d, a, d, c});
    }
  }
  return makeShape("tube", points, triangles);
}

// Two spheres apart from each other.
inline Shape twoSpheres() {
  const Shape one = icosphere(1);
  std::vector<Vec3> points = one.positions.values();
  std::vector<Index> triangles = one.mesh.triangles();
  const Index n = Index(points.size());
  for (Index v = 0; v < n; ++v) points.push_back(points[v] + Vec3(4, 0, 0));
  for (const Index v : one.mesh.triangles()) triangles.push_back(v + n);
  return makeShape("two spheres", points, triangles);
}

inline std::vector<Shape> closedShapes() {
  return {tetrahedron(), cube(), icosphere(0), icosphere(2), torus(24, 12), twoSpheres()};
}

inline std::vector<Shape> allShapes() {
  std::vector<Shape> shapes = closedShapes();
  for (const Shape& shape : {triangle(), grid(1), grid(9), tube(3, 1), tube(16, 8)})
    shapes.push_back(shape);
  return shapes;
}

}  // namespace remesher::patch_shapes
