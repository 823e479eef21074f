// SPDX-License-Identifier: MIT
// Relaxes a chart in the plane, so that its triangles come closer to their shape on the surface.
// Each round fits every triangle's true shape onto its place, then moves each vertex to the mean of
// the places that its triangles ask for [Liu et al. 2008, A Local/Global Approach to Mesh
// Parameterization; Bouaziz et al. 2012, Shape-Up], or further in the same direction [Wang 2015, A
// Chebyshev Semi-Iterative Approach for Accelerating Projective and Position-based Dynamics].
// Triangles that stay untrue weigh more and more.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/types.h"
#include "textures/charts/chart_packing.h"

namespace remesher {

// The rigid motion that brings one list of points nearest to another.
class PlaneMotion {
 public:
  PlaneMotion(std::span<const Vec2> from, std::span<const Vec2> to);
  Vec2 operator()(const Vec2& p) const;

 private:
  Vec2 from_ = Vec2::Zero(), to_ = Vec2::Zero();
  Vec2 turn_ = Vec2::UnitX();  // cosine and sine
};

// A triangle of the surface, laid into the plane in its true shape.
PlaneTriangle laidDown(const Vec3& a, const Vec3& b, const Vec3& c);

struct PlaneMesh {
  std::vector<Vec2> vertices;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<PlaneTriangle> wanted;  // per triangle
};

// Whether the relaxed mesh is true to the surface: no triangle is turned over, all areas are about
// right, and no triangle is stretched much. It is relaxed until it is, or for as long as it may
// become so; a true mesh gets the surface's area.
bool relax(PlaneMesh& mesh);

}  // namespace remesher
