// SPDX-License-Identifier: MIT
// How long the edges of the result should be at each place of the original. With adaptivity the
// size follows curvature: the error of a flat triangle with edges h over a surface of curvature k
// goes with k·h². For a given number of vertices h ∝ k^-1/2 makes the largest error smallest, and
// h ∝ k^-1/3 the mean square; full adaptivity lies between.
#pragma once

#include <memory>
#include <span>

#include "original/curves/spikes.h"
#include "original/surface/original_surface.h"
#include "original/surface/refined_faces.h"

namespace remesher {

struct SizeRules {
  double vertices = 0;     // how many a mesh of these sizes should have
  double adaptivity = 0;   // 0: even, 1: fully by curvature
  double gradation = 1.5;  // largest ratio between the sizes at the two ends of an edge
  std::span<const float> density = {};  // per original vertex (as BuiltMesh::sources), or empty
  double error = 0;  // if above 0: sizes are small enough for about this distance, model units
  const Spikes* spikes = nullptr;  // whose skin is to take few vertices, or none
};

class SizeField {
 public:
  SizeField(const OriginalSurface& surface, const SizeRules& rules);

  // The target edge length at a point, model units.
  double at(const SurfacePoint& p) const;
  double at(Vertex original) const { return sizes_[original]; }

  // The same sizes on a finer surface, each vertex of which takes that of its heir on this one.
  void moveOnto(const OriginalSurface& finer, const VertexData<Vertex>& heirs);

  // Whether it is the same everywhere.
  bool isEven() const { return even_; }
  // Whether the caller's own density is in it.
  bool isWished() const { return wished_; }
  // Whether spikes are left out of them: edges there are as long as the spikes.
  bool isSpiked() const { return spiked_; }
  // The edge length of an even mesh with that many vertices.
  double mean() const { return mean_; }
  // The mean over the edges of a mesh of these sizes: shorter than mean() where they are graded.
  double meanEdge() const { return meanEdge_; }
  // How many vertices a mesh of these sizes has: what was asked for, or more to keep an error.
  double vertices() const { return vertices_; }

 private:
  const HalfedgeMesh* mesh_;
  std::shared_ptr<const RefinedFaces> refined_;  // what the sizes are for, if not just vertices
  VertexData<double> sizes_;
  double mean_ = 0;
  double meanEdge_ = 0;
  double vertices_ = 0;
  bool wished_ = false;
  bool spiked_ = false;
  bool even_ = false;
};

// The edge length of `vertices` vertices spread evenly over an area: each owns two equilateral
// triangles.
double evenEdgeLength(double area, double vertices);
double verticesForEdgeLength(double area, double length);

}  // namespace remesher
