// SPDX-License-Identifier: MIT
// The surfaces every law is tried on, each with what is known of it by its making: the Euler
// characteristic χ, components, boundary loops. Smooth and sharp, open and closed, of genus 0 and
// 1, and those that are no manifold until the mesh builder has cut them.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher::shapes {

struct Shape {
  std::string name;
  TriangleMesh mesh;
  long chi;
  std::size_t components;
  std::size_t loops;
};

inline void addTriangle(TriangleMesh& mesh, Index a, Index b, Index c) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

inline Index addVertex(TriangleMesh& mesh, const Vec3& p) {
  mesh.positions.push_back(p);
  return Index(mesh.positions.size() - 1);
}

// Cells of two triangles over (columns + 1) × (rows + 1) points, with a new vertex per point:
// points that coincide are for the builder to weld. Counterclockwise where column, row are x, y.
inline void addSheet(TriangleMesh& mesh, int columns, int rows,
                     const std::function<Vec3(int, int)>& point) {
  const Index first = Index(mesh.positions.size()), stride = Index(columns + 1);
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) addVertex(mesh, point(column, row));
  for (Index row = 0; row < Index(rows); ++row)
    for (Index column = 0; column < Index(columns); ++column) {
      const Index a = first + row * stride + column, b = a + 1, c = b + stride, d = a + stride;
      addTriangle(mesh, a, b, c);
      addTriangle(mesh, a, c, d);
    }
}

// The k-th of n points on the unit circle, exactly the first again for k = n.
inline Vec3 onCircle(int k, int n) {
  const double angle = 2 * std::numbers::pi * (k % n) / n;
  return {std::cos(angle), std::sin(angle), 0};
}

// The length of an edge, on average.
inline double meanEdge(const TriangleMesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    sum += (mesh.positions[mesh.indices[i]] - mesh.positions[mesh.indices[next]]).norm();
  }
  return sum / double(mesh.indices.size());
}

inline TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  mesh.indices = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
  return mesh;
}

// The unit sphere: an icosahedron with every edge cut in n, 10 n² + 2 vertices once welded.
inline TriangleMesh icosphere(int n) {
  const double g = std::numbers::phi;
  const std::vector<Vec3> corners = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                     {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                     {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  const std::vector<Index> faces = {0, 11, 5, 0, 5,  1,  0,  1,  7,  0,  7, 10, 0, 10, 11,
                                    1, 5,  9, 5, 11, 4,  11, 10, 2,  10, 7, 6,  7, 1,  8,
                                    3, 9,  4, 3, 4,  2,  3,  2,  6,  3,  6, 8,  3, 8,  9,
                                    4, 9,  5, 2, 4,  11, 6,  2,  10, 8,  6, 7,  9, 8,  1};
  TriangleMesh mesh;
  // Summed over the corners in the order of their numbers, so that the triangles at an edge or a
  // corner make exactly the same point.
  const auto point = [&](const Index* face, int i, int k) {
    std::array<int, 12> weight{};
    weight[face[0]] += n - i - k, weight[face[1]] += i, weight[face[2]] += k;
    Vec3 sum = Vec3::Zero();
    for (std::size_t c = 0; c < 12; ++c)
      if (weight[c] != 0) sum += weight[c] * corners[c];
    return addVertex(mesh, sum.normalized());
  };
  for (std::size_t f = 0; f < faces.size(); f += 3)
    for (int i = 0; i < n; ++i)
      for (int k = 0; i + k < n; ++k) {
        const Index b = point(&faces[f], i + 1, k), c = point(&faces[f], i, k + 1);
        addTriangle(mesh, point(&faces[f], i, k), b, c);
        if (i + k + 1 < n) addTriangle(mesh, b, point(&faces[f], i + 1, k + 1), c);
      }
  return mesh;
}

// The rectangle n × m in the plane z = 0, in unit cells.
inline TriangleMesh grid(int n, int m) {
  TriangleMesh mesh;
  addSheet(mesh, n, m, [](int x, int y) { return Vec3(x, y, 0); });
  return mesh;
}

// Radius 1, height 2, both ends closed by a fan: two sharp rims of n edges.
inline TriangleMesh cylinder(int n, int rows) {
  TriangleMesh mesh;
  const auto point = [&](int k, int row) {
    return Vec3(onCircle(k, n) + Vec3(0, 0, 2.0 * row / rows - 1));
  };
  addSheet(mesh, n, rows, point);
  for (int k = 0; k < n; ++k) {
    addTriangle(mesh, addVertex(mesh, {0, 0, -1}), addVertex(mesh, point(k + 1, 0)),
                addVertex(mesh, point(k, 0)));
    addTriangle(mesh, addVertex(mesh, {0, 0, 1}), addVertex(mesh, point(k, rows)),
                addVertex(mesh, point(k + 1, rows)));
  }
  return mesh;
}

// The surface of the unit cells for which filled(x, y, z) holds, 0 ≤ x, y, z < n.
inline TriangleMesh cells(int n, const std::function<bool(int, int, int)>& filled) {
  TriangleMesh mesh;
  using Cell = std::array<int, 3>;
  const auto inside = [&](const Cell& c) {
    for (const int i : c)
      if (i < 0 || i >= n) return false;
    return filled(c[0], c[1], c[2]);
  };
  const auto addSide = [&](const Cell& cell, std::size_t axis, int side) {
    Vec3 corner(cell[0], cell[1], cell[2]), u = Vec3::Zero(), v = Vec3::Zero();
    corner[Eigen::Index(axis)] += side;
    u[Eigen::Index((axis + 1 + (side == 0)) % 3)] = 1;
    v[Eigen::Index((axis + 1 + (side == 1)) % 3)] = 1;
    addSheet(mesh, 1, 1, [&](int i, int k) { return Vec3(corner + i * u + k * v); });
  };
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        for (std::size_t axis = 0; axis < 3 && inside({x, y, z}); ++axis)
          for (const int side : {0, 1}) {
            Cell neighbor = {x, y, z};
            neighbor[axis] += 2 * side - 1;
            if (!inside(neighbor)) addSide({x, y, z}, axis, side);
          }
  return mesh;
}

// Edge length n, unit cells.
inline TriangleMesh cube(int n) {
  return cells(n, [](int, int, int) { return true; });
}

// A cube of edge length 3 with a square tunnel through it.
inline TriangleMesh boxWithHole() {
  return cells(3, [](int x, int y, int) { return x != 1 || y != 1; });
}

// Around the z axis at distance 2, thickness 1: n cells the long way, m around the tube.
inline TriangleMesh torus(int n, int m) {
  TriangleMesh mesh;
  addSheet(mesh, n, m, [&](int i, int k) {
    const Vec3 long_ = onCircle(i, n), tube = onCircle(k, m);
    return Vec3((2 + tube.x()) * long_ + Vec3(0, 0, tube.y()));
  });
  return mesh;
}

// Base of n edges, closed below by one fan; the apex above has valence n.
inline TriangleMesh cone(int n) {
  TriangleMesh mesh;
  const Index apex = addVertex(mesh, {0, 0, 2}), center = addVertex(mesh, {0, 0, 0});
  for (int k = 0; k < n; ++k) addVertex(mesh, onCircle(k, n));
  for (Index k = 0; k < Index(n); ++k) {
    const Index next = (k + 1) % Index(n);
    addTriangle(mesh, apex, 2 + k, 2 + next);
    addTriangle(mesh, center, 2 + next, 2 + k);
  }
  return mesh;
}

// Two triangles that touch in one vertex.
inline TriangleMesh bowTie() {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}};
  mesh.indices = {0, 1, 2, 0, 3, 4};
  return mesh;
}

// n cells long, with half a twist.
inline TriangleMesh moebiusStrip(int n) {
  TriangleMesh mesh;
  addSheet(mesh, n, 1, [&](int i, int k) {
    const double half = std::numbers::pi * (i % n) / n;
    const double across = ((i == n) == (k == 0) ? 0.5 : -0.5);
    const Vec3 out = onCircle(i, n);
    return Vec3(2 * out + across * (std::cos(half) * out + std::sin(half) * Vec3(0, 0, 1)));
  });
  return mesh;
}

// n needles in the plane z = 0, side by side from one apex.
inline TriangleMesh sliverFan(int n) {
  TriangleMesh mesh;
  addVertex(mesh, {0, 0, 0});
  for (int k = 0; k <= n; ++k) addVertex(mesh, {1, 1e-3 * k, 0});
  for (Index k = 0; k < Index(n); ++k) addTriangle(mesh, 0, k + 1, k + 2);
  return mesh;
}

// Three triangles at the edge 0-1: the first two lie flat and agree, the third stands on them.
inline TriangleMesh threeAtAnEdge() {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  mesh.indices = {0, 1, 2, 1, 0, 3, 0, 1, 4};
  return mesh;
}

inline TriangleMesh twoComponents() {
  TriangleMesh mesh = tetrahedron();
  for (const Vec3& p : tetrahedron().positions) addVertex(mesh, p + Vec3(5, 0, 0));
  for (const Index v : tetrahedron().indices) mesh.indices.push_back(4 + v);
  return mesh;
}

// Everything above that is an oriented manifold once welded. χ of a surface of genus g with b
// boundary loops is 2 − 2g − b, summed over the components.
inline std::vector<Shape> manifolds() {
  return {{"tetrahedron", tetrahedron(), 2, 1, 0},
          {"icosphere", icosphere(3), 2, 1, 0},
          {"grid", grid(5, 4), 1, 1, 1},
          {"strip", grid(4, 1), 1, 1, 1},
          {"triangle pair", grid(1, 1), 1, 1, 1},
          {"cylinder", cylinder(8, 3), 2, 1, 0},
          {"cube", cube(2), 2, 1, 0},
          {"box with hole", boxWithHole(), 0, 1, 0},
          {"torus", torus(8, 5), 0, 1, 0},
          {"thin torus", torus(8, 3), 0, 1, 0},
          {"cone", cone(9), 2, 1, 0},
          {"sliver fan", sliverFan(7), 1, 1, 1},
          {"two components", twoComponents(), 4, 2, 0}};
}

// Those that the mesh builder has to cut; χ, components and loops are what is left after it.
inline std::vector<Shape> nonManifolds() {
  return {{"bow tie", bowTie(), 2, 2, 2},
          {"Möbius strip", moebiusStrip(7), 1, 1, 1},
          {"three triangles at an edge", threeAtAnEdge(), 2, 2, 2}};
}

inline std::vector<Shape> all() {
  std::vector<Shape> result = manifolds();
  for (Shape& shape : nonManifolds()) result.push_back(std::move(shape));
  return result;
}

}  // namespace remesher::shapes
