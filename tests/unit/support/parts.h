// SPDX-License-Identifier: MIT
// Machine parts with flat sides: a bar whose flat bottom runs into fillets, a plate with a hole.
#pragma once

#include <cmath>
#include <numbers>

#include "geometry/triangle.h"
#include "support/shapes.h"

namespace remesher::shapes {

// A convex outline in the plane of y and z, counterclockwise, drawn out along x.
inline TriangleMesh extruded(const std::vector<Vec2>& outline, double length) {
  TriangleMesh mesh;
  const Index n = Index(outline.size());
  for (const double x : {0.0, length})
    for (const Vec2& p : outline) addVertex(mesh, {x, p.x(), p.y()});
  for (Index i = 0; i < n; ++i) {
    const Index next = (i + 1) % n;
    addTriangle(mesh, i, n + next, next);
    addTriangle(mesh, i, n + i, n + next);
  }
  for (Index i = 2; i < n; ++i) {
    addTriangle(mesh, 0, i, i - 1);
    addTriangle(mesh, n, n + i - 1, n + i);
  }
  return mesh;
}

inline constexpr double kBarLength = 6, kBarWidth = 4, kFilletRadius = 0.4;

// Its bottom, at z = 0, is flat between the two fillets, each of so many facets.
inline TriangleMesh filletedBar(int facets) {
  std::vector<Vec2> outline;
  const auto arc = [&](double y, double from) {
    for (int i = 0; i <= facets; ++i) {
      const double turn = from + 0.5 * std::numbers::pi * i / facets;
      const double sine = i == 0 || i == facets ? std::round(std::sin(turn)) : std::sin(turn);
      const double cosine = i == 0 || i == facets ? std::round(std::cos(turn)) : std::cos(turn);
      outline.push_back({y + kFilletRadius * cosine, kFilletRadius + kFilletRadius * sine});
    }
  };
  arc(kBarWidth - kFilletRadius, -0.5 * std::numbers::pi);
  outline.push_back({kBarWidth, 1});
  outline.push_back({0, 1});
  arc(kFilletRadius, -std::numbers::pi);
  return extruded(outline, kBarLength);
}

// A square of side 4, of that thickness, with a hole of 4 n sides in the middle, radius 0.5.
inline TriangleMesh drilledPlate(Index n, double thickness) {
  TriangleMesh mesh;
  const Index sides = 4 * n, around = sides + 4;
  for (const double z : {0.0, thickness}) {
    for (Index i = 0; i < sides; ++i) {
      const Vec3 p = onCircle(int(i), int(sides));
      addVertex(mesh, {0.5 * p.x(), 0.5 * p.y(), z});
    }
    for (const Vec2& p : {Vec2(2, 2), Vec2(-2, 2), Vec2(-2, -2), Vec2(2, -2)})
      addVertex(mesh, {p.x(), p.y(), z});
  }
  const auto top = [&](Index a, Index b, Index c) {
    addTriangle(mesh, around + a, around + b, around + c);
    addTriangle(mesh, a, c, b);
  };
  const auto wall = [&](Index a, Index b) {
    addTriangle(mesh, a, b, around + b);
    addTriangle(mesh, a, around + b, around + a);
  };
  for (Index i = 0; i < sides; ++i) {
    const Index next = (i + 1) % sides;
    top(i, sides + i / n, next);
    wall(next, i);
  }
  for (Index k = 0; k < 4; ++k) {
    const Index next = (k + 1) % 4;
    top(sides + k, sides + next, (k + 1) * n % sides);
    wall(sides + k, sides + next);
  }
  return mesh;
}

// Of the triangles that lie in the plane at that height.
inline double areaAt(const TriangleMesh& mesh, double z) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec3 &a = mesh.positions[mesh.indices[i]], &b = mesh.positions[mesh.indices[i + 1]],
               &c = mesh.positions[mesh.indices[i + 2]];
    if (a.z() == z && b.z() == z && c.z() == z) sum += area(a, b, c);
  }
  return sum;
}

}  // namespace remesher::shapes
