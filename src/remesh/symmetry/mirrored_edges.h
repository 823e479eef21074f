// SPDX-License-Identifier: MIT
// Edges of a surface, and the edges onto which planes mirror them: a seam on one side only does not
// keep quads from being mirrored if its mirror image runs along edges.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/part_options.h"
#include "geometry/triangle_tree.h"
#include "mesh/mesh_builder.h"

namespace remesher {

using VertexPair = std::pair<Index, Index>;

class MirroredEdges {
 public:
  // built must outlive the object. tolerance: how far mirrored ends may be from vertices.
  MirroredEdges(const BuiltMesh& built, double tolerance);

  void add(const std::vector<Halfedge>& edges);

  // Adds the images of all edges so far that are edges. False, and nothing is added, if an image is
  // none and its middle does not lie on the given edges either.
  bool addImages(const MirrorPlane& plane);

  // The edges that were added as images, each as the first input vertices at its ends.
  std::vector<VertexPair> images() const;

 private:
  Vertex vertexNear(const Vec3& p) const;
  bool isEdge(Vertex a, Vertex b) const;
  bool isOnGiven(const Vec3& p);

  const BuiltMesh& built_;
  const double tolerance_;
  std::multimap<double, Vertex> byX_;
  std::set<VertexPair> edges_, given_;  // by the surface's vertices, the lower first
  std::vector<Index> lines_;            // the given edges as triangles without area
  std::optional<TriangleTree> tree_;    // of these
};

}  // namespace remesher
