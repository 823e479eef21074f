// SPDX-License-Identifier: MIT
// Paints maps anew. For each texel: the point of the new triangle, from there the place on the
// original, and there everything that its material says, averaged in linear light over several
// points of the texel.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/progress.h"
#include "textures/painting/canvas.h"
#include "textures/painting/paint_finder.h"
#include "textures/painting/paint_source.h"

namespace remesher {

struct CanvasCorner {
  Vec3 position;
  Vec3 facing, normal;      // unit: of the shape, and for light
  Eigen::Vector4d tangent;  // with its side, as from computeTangents
  Vec2 texel;
  InputPlace place;
};

struct CanvasTriangle {
  std::array<CanvasCorner, 3> corners;
  Index source;                          // the number of its original
  std::array<char, 3> rims = {1, 1, 1};  // per corner: whether the look ends at the edge from it
};

struct PaintRules {
  Index size;     // texels
  bool isOpaque;  // alpha means nothing
  double finer;   // texels of the original per new texel, along a side
  // Per source: how far places are looked for along the normals; empty: places are on the surface
  // that is connected to the corners' places.
  std::vector<double> cages = {};
  bool occludes = false;  // the ambient occlusion of the source is painted, too
};

// The four maps; the channels of `surface` are occlusion, roughness, metal.
struct Painting {
  io::Image baseColor, surface, emissive, normal;
  std::size_t texels = 0, lost = 0;  // all that triangles cover; those for which nothing was found
};

Painting paint(std::span<const CanvasTriangle> triangles,
               std::span<const std::unique_ptr<PaintSource>> sources, const PaintRules& rules,
               const Progress& progress);

}  // namespace remesher
