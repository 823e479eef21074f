// SPDX-License-Identifier: MIT
// Closed bodies that touch face to face, with different triangles on either side.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "base/triangle_mesh.h"
#include "support/shapes.h"

namespace remesher::shapes {

// How many squares a box has along each axis, and whether their diagonals run the other way.
struct Squares {
  std::array<int, 3> count = {1, 1, 1};
  bool isFlipped = false;
};

inline TriangleMesh box(const Vec3& low, const Vec3& high, const Squares& squares = {}) {
  TriangleMesh mesh;
  const auto add = [&](Eigen::Index left, double at, bool isTop) {
    const Eigen::Index u = (left + 1) % 3, v = (left + 2) % 3;
    const int columns = squares.count[std::size_t(u)], rows = squares.count[std::size_t(v)];
    const auto point = [&](int i, int k) {
      Vec3 p;
      p[left] = at;
      p[u] = low[u] + (high[u] - low[u]) * i / columns;
      p[v] = low[v] + (high[v] - low[v]) * k / rows;
      return addVertex(mesh, p);
    };
    for (int i = 0; i < columns; ++i)
      for (int k = 0; k < rows; ++k) {
        std::array<Index, 4> c = {point(i, k), point(i + 1, k), point(i + 1, k + 1),
                                  point(i, k + 1)};
        if (!isTop) std::swap(c[1], c[3]);
        const std::size_t first = squares.isFlipped ? 1 : 0;
        addTriangle(mesh, c[first], c[first + 1], c[first + 2]);
        addTriangle(mesh, c[first], c[first + 2], c[(first + 3) % 4]);
      }
  };
  for (const Eigen::Index axis : {0, 1, 2})
    add(axis, low[axis], false), add(axis, high[axis], true);
  return mesh;
}

// Between two radii; a shaft for an inner radius of 0.
struct Pipe {
  double inner, outer, low, high;
  bool isFlipped = false;
};

inline TriangleMesh pipe(int n, const Pipe& shape) {
  TriangleMesh mesh;
  const auto at = [&](double radius, int k, double z) {
    return addVertex(mesh, radius * onCircle(k, n) + Vec3(0, 0, z));
  };
  const auto quad = [&](std::array<Index, 4> c) {
    const std::size_t first = shape.isFlipped ? 1 : 0;
    addTriangle(mesh, c[first], c[first + 1], c[first + 2]);
    addTriangle(mesh, c[first], c[first + 2], c[(first + 3) % 4]);
  };
  const auto [inner, outer, low, high, isFlipped] = shape;
  for (int k = 0; k < n; ++k) {
    quad({at(outer, k, low), at(outer, k + 1, low), at(outer, k + 1, high), at(outer, k, high)});
    if (inner == 0) {
      addTriangle(mesh, at(0, 0, low), at(outer, k + 1, low), at(outer, k, low));
      addTriangle(mesh, at(0, 0, high), at(outer, k, high), at(outer, k + 1, high));
      continue;
    }
    quad({at(inner, k + 1, low), at(inner, k, low), at(inner, k, high), at(inner, k + 1, high)});
    quad({at(inner, k, low), at(inner, k + 1, low), at(outer, k + 1, low), at(outer, k, low)});
    quad({at(inner, k + 1, high), at(inner, k, high), at(outer, k, high), at(outer, k + 1, high)});
  }
  return mesh;
}

// All as one mesh, each in a group of its own.
inline TriangleMesh together(const std::vector<TriangleMesh>& bodies) {
  TriangleMesh all;
  for (const TriangleMesh& body : bodies) {
    const Index first = Index(all.positions.size());
    const Index group = all.groups.empty() ? 0 : all.groups.back() + 1;
    all.positions.insert(all.positions.end(), body.positions.begin(), body.positions.end());
    for (const Index v : body.indices) all.indices.push_back(first + v);
    all.groups.resize(all.indices.size() / 3, group);
  }
  return all;
}

inline TriangleMesh twoBoxes(double gap = 0) {
  return together(
      {box({0, 0, 0}, {1, 1, 1}), box({1 + gap, 0, 0}, {2 + gap, 1, 1}, {{2, 3, 2}, true})});
}
inline TriangleMesh boxOnPlate() {
  return together({box({0, 0, 0}, {4, 4, 0.5}, {{5, 5, 1}}),
                   box({1.1, 1.3, 0.5}, {2.2, 2.3, 1.5}, {{1, 1, 1}, true})});
}
inline TriangleMesh threeLayers() {
  return together({box({0, 0, 0}, {2, 2, 0.5}), box({0, 0, 0.5}, {2, 2, 0.8}, {{2, 2, 1}, true}),
                   box({0, 0, 0.8}, {2, 2, 1.8}, {{3, 3, 3}})});
}
// One hangs over the edges of the other.
inline TriangleMesh boxesInAnL() {
  return together({box({0, 0, 0}, {2, 1, 1}), box({0.5, 1, 0}, {1.3, 2, 1.4}, {{2, 1, 1}})});
}
inline TriangleMesh shaftInBore() {
  return together({pipe(24, {0, 0.5, -1, 1.5}), pipe(24, {0.5, 1.2, -0.3, 0.6, true})});
}
// The shell is one body with two pieces of surface: its outside, and the cavity that the ball
// fills.
inline TriangleMesh ballInShell() {
  TriangleMesh ball = icosphere(4);
  TriangleMesh outside = ball, cavity = ball;
  // Rounded otherwise than the cavity.
  for (Vec3& p : ball.positions) p += 1e-7 * Vec3(p.y() * p.z(), p.x() * p.x(), p.x() - p.y());
  for (Vec3& p : outside.positions) p *= 2;
  for (std::size_t i = 0; i < cavity.indices.size(); i += 3)
    std::swap(cavity.indices[i + 1], cavity.indices[i + 2]);
  TriangleMesh all = together({cavity, outside, ball});
  for (Index& group : all.groups) group = group == 2 ? 0 : 1;
  return all;
}
// Eight cubes around one corner: four faces meet at each edge between them.
inline TriangleMesh eightCubes() {
  std::vector<TriangleMesh> cubes;
  for (int i = 0; i < 8; ++i) {
    const Vec3 low(i % 2, i / 2 % 2, i / 4);
    cubes.push_back(box(low, low + Vec3::Ones(), {{1 + i % 2, 1 + i / 2 % 2, 1 + i / 4}}));
  }
  return together(cubes);
}

}  // namespace remesher::shapes
