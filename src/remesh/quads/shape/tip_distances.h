// SPDX-License-Identifier: MIT
// How far quads are from the vertices of the original: most of what quads lack of a shape is at
// tips and ridges, which have vertices there.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/triangle_tree.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// A vertex of the original.
struct Tip {
  Index vertex;
  CurvePoint on;  // its place if it is on a curve and no corner
  double distance = 0;
  Index triangle = kNone;  // of QuadTree: one that is near enough, else the nearest one
  Index quad() const { return triangle / 2; }
};

// All vertices of the original but corners, which quads have already.
std::vector<Tip> possibleTips(const OriginalSurface& surface);

// A tree of the quads as triangles, two each, as they are now.
class QuadTree {
 public:
  explicit QuadTree(const QuadMesh& mesh);

  const TriangleTree& operator*() const { return *tree_; }
  // The corners of a triangle, as numbers of vertices of the quads.
  std::array<Index, 3> corners(Index triangle) const;

 private:
  std::vector<Vec3> positions_;
  std::vector<Index> indices_;
  std::optional<TriangleTree> tree_;
};

// Measures the distances of all that may be tips. Where less than `least` is known, that is enough.
void measure(std::vector<Tip>& possible, const QuadTree& tree, const OriginalSurface& surface,
             double least);

}  // namespace remesher
