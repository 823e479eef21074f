// SPDX-License-Identifier: MIT
// Meshes that are hard on arithmetic, on topology or on memory: what broken and malicious files
// look like. Each comes from a formula, so that what it must turn into can be told from that.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "support/shapes.h"
#include "support/soups.h"

namespace remesher::shapes {

// One triangle, 1 wide and so high.
inline TriangleMesh flatTriangle(double height) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.4, height, 0}};
  mesh.indices = {0, 1, 2};
  return mesh;
}

// Open, along the x axis, of `rings` rings of n vertices.
inline TriangleMesh tube(int n, int rings, double radius, double length) {
  TriangleMesh mesh;
  addSheet(mesh, n, rings - 1, [&](int k, int ring) {
    const Vec3 p = radius * onCircle(k, n);
    return Vec3(length * ring / (rings - 1), p.x(), p.y());
  });
  return mesh;
}

// n × n cells, each so many times as wide as high.
inline TriangleMesh stretchedSheet(int n, double ratio) {
  TriangleMesh mesh;
  addSheet(mesh, n, n, [&](int i, int k) { return Vec3(ratio * i, k, 0); });
  return mesh;
}

// Random triangles between points that lie on a line but for `off`.
inline TriangleMesh nearlyOnALine(int triangles, double off) {
  soups::Random random(7);
  for (int i = 0; i < 8; ++i) random.number();
  TriangleMesh mesh;
  addSheet(mesh, triangles / 2, 1, [&](int i, int k) {
    return Vec3(i + 0.5 * k, off * random.number(), off * random.number());
  });
  return mesh;
}

// The sphere with the vertex nearest to the x axis at so many radii.
inline TriangleMesh spikedSphere(int n, double radii) {
  TriangleMesh mesh = icosphere(n);
  Vec3 tip = mesh.positions[0];
  for (const Vec3& p : mesh.positions)
    if (p.x() > tip.x()) tip = p;
  for (Vec3& p : mesh.positions)
    if (p == tip) p = {radii, 0, 0};
  return mesh;
}

// The sphere with every `every`-th vertex pulled out to so many radii: small spikes all over.
inline TriangleMesh urchin(int n, int every, double radii) {
  TriangleMesh mesh = icosphere(n);
  const auto isSpike = [&](const Vec3& p) {
    const double code = std::abs(std::sin(37.1 * p.x() + 71.7 * p.y() + 113.3 * p.z()));
    return code * every < 1;
  };
  for (Vec3& p : mesh.positions)
    if (isSpike(p)) p *= radii;
  return mesh;
}

// Every k-th vertex of the sphere near `size`, the others as they are.
inline TriangleMesh mixedScales(int n, double size) {
  TriangleMesh mesh = icosphere(n);
  for (Vec3& p : mesh.positions)
    if (std::abs(std::sin(51.3 * p.x() + 17.9 * p.y() + 5.7 * p.z())) < 0.1) p *= size;
  return mesh;
}

inline TriangleMesh scaled(TriangleMesh mesh, double by) {
  for (Vec3& p : mesh.positions) p *= by;
  return mesh;
}

// Two cubes, n cells to an edge, that share one edge of theirs.
inline TriangleMesh cubesSharingAnEdge(int n) {
  return soups::joined({cube(n), soups::moved(cube(n), Vec3(n, n, 0))});
}

// Two cubes that share one corner.
inline TriangleMesh cubesSharingACorner(int n) {
  return soups::joined({cube(n), soups::moved(cube(n), Vec3(n, n, n))});
}

inline TriangleMesh turnedOver(TriangleMesh mesh) {
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3)
    std::swap(mesh.indices[t + 1], mesh.indices[t + 2]);
  return mesh;
}

// A sheet with both its sides, vertices shared: closed and flat.
inline TriangleMesh doubledSheet(int n) {
  return soups::joined({grid(n, n), turnedOver(grid(n, n))});
}

// Two layers whose triangles differ, joined at the rim only: a flat balloon.
inline TriangleMesh flatBalloon(int n) {
  TriangleMesh below;
  addSheet(below, n, n, [&](int i, int k) { return Vec3(n - i, k, 0); });
  return soups::joined({grid(n, n), below});
}

// Every surface twice, the second time turned over.
inline TriangleMesh doubledSphere(int n) {
  return soups::joined({icosphere(n), turnedOver(icosphere(n))});
}

// The bottle immersed in space as a figure 8 that turns over.
inline TriangleMesh kleinBottle(int n, int m) {
  TriangleMesh mesh;
  addSheet(mesh, n, m, [&](int i, int k) {
    // Once around, the section has turned by half: the last ring is the first, run through
    // backwards.
    const int at = i == n ? (m - k) % m : k % m;
    const double u = 2 * std::numbers::pi * (i % n) / n, v = 2 * std::numbers::pi * at / m;
    const double half = u / 2;
    const double r = 3 + std::cos(half) * std::sin(v) - std::sin(half) * std::sin(2 * v);
    return Vec3(r * std::cos(u), r * std::sin(u),
                std::sin(half) * std::sin(v) + std::cos(half) * std::sin(2 * v));
  });
  return mesh;
}

// n leaves of m × m cells at one spine.
inline TriangleMesh book(int leaves, int m) {
  TriangleMesh mesh;
  for (int leaf = 0; leaf < leaves; ++leaf) {
    const Vec3 out = onCircle(leaf, leaves);
    addSheet(mesh, m, m, [&](int i, int k) { return Vec3(double(i) * out + Vec3(0, 0, k)); });
  }
  return mesh;
}

// The unit sphere in meridians and parallels; each pole is one vertex.
inline TriangleMesh globe(int meridians, int parallels) {
  TriangleMesh mesh;
  addVertex(mesh, {0, 0, -1});
  for (int row = 1; row < parallels; ++row) {
    const double angle = std::numbers::pi * row / parallels;
    for (int k = 0; k < meridians; ++k) {
      const Vec3 p = std::sin(angle) * onCircle(k, meridians);
      addVertex(mesh, {p.x(), p.y(), -std::cos(angle)});
    }
  }
  const Index top = addVertex(mesh, {0, 0, 1});
  const auto at = [&](int row, int k) {
    if (row == 0) return Index{0};
    return row == parallels ? top : Index(1 + (row - 1) * meridians + k % meridians);
  };
  for (int row = 0; row < parallels; ++row)
    for (int k = 0; k < meridians; ++k) {
      const Index a = at(row, k), b = at(row, k + 1), c = at(row + 1, k + 1), d = at(row + 1, k);
      if (a != b) addTriangle(mesh, a, b, c);
      if (c != d) addTriangle(mesh, a, c, d);
    }
  return mesh;
}

// A disk of n triangles at one vertex.
inline TriangleMesh wheel(int n) {
  TriangleMesh mesh;
  addVertex(mesh, {0, 0, 0});
  for (int k = 0; k < n; ++k) addVertex(mesh, onCircle(k, n));
  for (Index k = 0; k < Index(n); ++k) addTriangle(mesh, 0, 1 + k, 1 + (k + 1) % Index(n));
  return mesh;
}

// A ring with two rims of n edges.
inline TriangleMesh annulus(int n) {
  TriangleMesh mesh;
  addSheet(mesh, n, 1, [&](int k, int row) { return Vec3((2.0 - row * 1.0) * onCircle(k, n)); });
  return mesh;
}

// Triangles that touch nothing, in a square grid.
inline TriangleMesh looseTriangles(int n) {
  TriangleMesh mesh;
  const int side = int(std::ceil(std::sqrt(double(n))));
  for (int i = 0; i < n; ++i) {
    const Vec3 at(2.0 * (i % side), 2.0 * (i / side), 0);
    soups::addTriangle(mesh, at, at + Vec3(1, 0, 0), at + Vec3(0.5, 0.8, 0));
  }
  return mesh;
}

// Random needles: long triangles, thin ends.
inline TriangleMesh needles(int n, double thickness) {
  soups::Random random(11);
  for (int i = 0; i < 8; ++i) random.number();
  TriangleMesh mesh;
  for (int i = 0; i < n; ++i) {
    const Vec3 a = random.point(), b = random.point();
    soups::addTriangle(mesh, a, b, b + thickness * (random.point() - Vec3::Constant(0.5)));
  }
  return mesh;
}

// What a CAD system writes of bolts in a plate: closed cylinders and cubes whose sides are strips
// from rim to rim, flat ends of needles, and triangles without area at every straight edge.
inline TriangleMesh assembly(int parts, int segments, int degenerate) {
  TriangleMesh mesh;
  for (int part = 0; part < parts; ++part) {
    const Vec3 at(3.0 * (part % 8), 3.0 * (part / 8), 0);
    TriangleMesh piece;
    const auto rim = [&](int k, double z) { return Vec3(onCircle(k, segments) + Vec3(0, 0, z)); };
    addSheet(piece, segments, 1, [&](int k, int row) { return rim(k, 20.0 * row); });
    for (int k = 1; k + 1 < segments; ++k) {
      soups::addTriangle(piece, rim(0, 20), rim(k, 20), rim(k + 1, 20));
      soups::addTriangle(piece, rim(0, 0), rim(k + 1, 0), rim(k, 0));
    }
    for (int k = 0; k < degenerate / parts; ++k) {
      const Vec3 a = rim(k % segments, 0), b = rim(k % segments, 20);
      soups::addTriangle(piece, a, b, Vec3((a + b) / 2));
    }
    for (Vec3& p : piece.positions) p += at;
    mesh = soups::joined({mesh, piece});
  }
  return mesh;
}

}  // namespace remesher::shapes
