// SPDX-License-Identifier: MIT
// How far quads are from a surface.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/mesh_tree.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

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

// Tells maps that follow a surface from those that leave it.
class QuadDistance {
 public:
  // The mesh must outlive it.
  explicit QuadDistance(const WorkingMesh& mesh);

  // The largest distance of the mesh's vertices from the quads, and of the middles of some quads
  // from the mesh, in sides of quads; 0 if all are nearer than `least` sides.
  double sidesAway(const QuadMesh& quads, double least = 1) const;
  // The same of the quads' middles only: tips that are still to be reached do not count.
  double quadsAway(const QuadMesh& quads, double least = 1) const;

 private:
  const WorkingMesh& mesh_;
  const MeshTree tree_;
};

// How far quads are from the original.
class OriginalDistance {
 public:
  // ground: any mesh on the original, which must outlive it.
  explicit OriginalDistance(const WorkingMesh& ground);

  // The largest distance of the original's and the ground's vertices from the quads, and of the
  // middles of their triangles and sides from the original.
  double farthest(const QuadMesh& quads) const;

 private:
  const WorkingMesh& ground_;
  const MeshTree tree_;
};

}  // namespace remesher
