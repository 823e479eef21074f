// SPDX-License-Identifier: MIT
// The square that is painted on: which texel belongs to which triangle of an atlas, and what the
// texels between the charts become.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "io/model/material.h"

namespace remesher {

using TexelTriangle = std::array<Vec2, 3>;  // in texels

// Per texel the triangle over its middle, or else the nearest if it is no farther than a texel, or
// kNone.
std::vector<Index> coveredTexels(std::span<const TexelTriangle> triangles, Index size);

// The weights of a triangle's corners at a point of its plane, also beside it.
Vec3 weightsAt(const TexelTriangle& triangle, const Vec2& point);

// A triangle of which some edges are rims, behind which another look begins.
class RimmedTriangle {
 public:
  RimmedTriangle() = default;
  RimmedTriangle(const TexelTriangle& triangle, const std::array<char, 3>& rims);

  // A point as it is or, beyond a rim, the nearest within, or nearly: what lies there is looked at
  // from another chart.
  Vec2 kept(Vec2 point) const {
    for (std::size_t k = 0; k < count_; ++k) point = kept(point, rims_[k]);
    return point;
  }

 private:
  struct Rim {
    Vec2 from, edge;
    double length;
    double least;  // how far within points are kept
  };
  static Vec2 kept(const Vec2& point, const Rim& rim);

  std::array<Rim, 3> rims_;
  std::size_t count_ = 0;
};

// Every texel that is nobody's becomes the mean of its neighbours that are somebody's, ring after
// ring: what looks beyond the rim of a chart, as coarse mip levels do, finds what is within. All
// images have the same size.
void fillGutters(std::span<io::Image* const> images, std::span<const Index> owners);

}  // namespace remesher
