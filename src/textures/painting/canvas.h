// SPDX-License-Identifier: MIT
// The square to paint on: which texel belongs to which triangle of an atlas, and how the texels
// between the charts are filled.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "io/model/material.h"

namespace remesher {

using TexelTriangle = std::array<Vec2, 3>;  // in texels

// Per texel the triangle over its middle, or the nearest triangle within a texel, or kNone.
std::vector<Index> coveredTexels(std::span<const TexelTriangle> triangles, Index size);

// The weights of a triangle's corners at a point of its plane, inside or outside.
Vec3 weightsAt(const TexelTriangle& triangle, const Vec2& point);

// A triangle some of whose edges are rims, beyond which another look begins.
class RimmedTriangle {
 public:
  RimmedTriangle() = default;
  RimmedTriangle(const TexelTriangle& triangle, const std::array<char, 3>& rims);

  // The point itself or, beyond a rim, about the nearest point inside: the place beyond a rim is
  // shown by another chart.
  Vec2 kept(Vec2 point) const {
    for (std::size_t k = 0; k < count_; ++k) point = kept(point, rims_[k]);
    return point;
  }

 private:
  struct Rim {
    Vec2 from, edge;
    double length;
    double least;  // points are kept this far inside
  };
  static Vec2 kept(const Vec2& point, const Rim& rim);

  std::array<Rim, 3> rims_;
  std::size_t count_ = 0;
};

// Fills every texel without an owner with the mean of its filled neighbours, ring after ring. So a
// look-up beyond the rim of a chart, as in coarse mip levels, finds the chart's own colours. All
// images have the same size.
void fillGutters(std::span<io::Image* const> images, std::span<const Index> owners);

}  // namespace remesher
