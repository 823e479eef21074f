// SPDX-License-Identifier: MIT
// A chart in the plane, its triangles brought nearer to what they are on the surface: each is laid
// as it is there onto where it lies, and each vertex goes to the mean of the places that its
// triangles ask for [Liu et al. 2008, A Local/Global Approach to Mesh Parameterization; Bouaziz et
// al. 2012, Shape-Up].
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/types.h"
#include "textures/charts/chart_packing.h"

namespace remesher {

// The motion that brings one row of points nearest to another.
class PlaneMotion {
 public:
  PlaneMotion(std::span<const Vec2> from, std::span<const Vec2> to);
  Vec2 operator()(const Vec2& p) const;

 private:
  Vec2 from_ = Vec2::Zero(), to_ = Vec2::Zero();
  Vec2 turn_ = Vec2::UnitX();  // cosine and sine
};

// A triangle as it is on the surface, laid into the plane.
PlaneTriangle laidDown(const Vec3& a, const Vec3& b, const Vec3& c);

struct PlaneMesh {
  std::vector<Vec2> vertices;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<PlaneTriangle> wanted;  // per triangle
};

void relax(PlaneMesh& mesh);

// Whether no triangle is turned over, all are about as large as they should be, and none is
// stretched much.
bool isTrue(const PlaneMesh& mesh);

}  // namespace remesher
