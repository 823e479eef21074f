// SPDX-License-Identifier: MIT
// The target edge length at each place of the original. With adaptivity the size follows curvature:
// a flat triangle with edges h over a surface of curvature k has an error proportional to k·h². For
// a given number of vertices h ∝ k^-1/2 minimises the largest error, and h ∝ k^-1/3 the mean
// square; full adaptivity lies between.
#pragma once

#include <memory>
#include <span>
#include <utility>

#include "original/curves/spikes.h"
#include "original/surface/original_surface.h"
#include "original/surface/refined_faces.h"

namespace remesher {

// Relative lengths from which on splitting an edge, or collapsing it, brings it nearer to its
// target [Botsch & Kobbelt 2004].
inline constexpr double kLong = 4.0 / 3, kShort = 4.0 / 5;

struct SizeRules {
  double vertices = 0;     // how many a mesh of these sizes should have
  double adaptivity = 0;   // 0: even, 1: fully by curvature
  double gradation = 1.5;  // largest ratio between the sizes at the two ends of an edge
  std::span<const float> density = {};  // per original vertex (as BuiltMesh::sources), or empty
  double error = 0;                     // if above 0: sizes keep about this distance, model units
  double shortest = 0, longest = kInfinity;  // bounds on sizes, as far as the number allows
  const Spikes* spikes = nullptr;            // spikes whose skin gets few vertices, or null
};

class SizeField {
 public:
  SizeField(const OriginalSurface& surface, const SizeRules& rules);

  // The target edge length at a point, model units.
  double at(const SurfacePoint& p) const;
  double at(Vertex original) const { return sizes_[original]; }

  // The same sizes on a finer surface. collapseMap: per vertex of the finer surface the vertex here
  // whose size it takes.
  void moveOnto(const OriginalSurface& finer, const VertexData<Vertex>& collapseMap);

  // Lowers sizes of the surface's vertices to these at most, and those around them as gradation
  // asks. Returns how many vertices more a mesh of these sizes has. Sizes that are the caller's
  // wish or keep an error, and those of places in flat faces, stay.
  double narrow(const OriginalSurface& surface, std::span<const std::pair<Vertex, double>> sizes);

  // Whether the size is the same everywhere.
  bool isEven() const { return even_; }
  // Whether the sizes include the caller's own density.
  bool isWished() const { return wished_; }
  // Whether sizes leave out spikes, whose edges are as long as the spikes.
  bool isSpiked() const { return spiked_; }
  // The edge length of a uniform mesh with the wanted number of vertices.
  double mean() const { return mean_; }
  // The mean over the edges of a mesh of these sizes; shorter than mean() where sizes are graded.
  double meanEdge() const { return meanEdge_; }
  // The number of vertices of a mesh of these sizes: the wanted number, or more to keep an error.
  double vertices() const { return vertices_; }

 private:
  const HalfedgeMesh* mesh_;
  std::shared_ptr<const RefinedFaces> refined_;  // if set, sizes are per place of these faces
  VertexData<double> sizes_;
  double mean_ = 0;
  double meanEdge_ = 0;
  double vertices_ = 0;
  double slope_ = 0;  // of gradation
  bool wished_ = false;
  bool bounded_ = false;  // sizes keep an error
  bool spiked_ = false;
  bool even_ = false;
};

// The edge length of `vertices` vertices spread evenly over an area: each owns two equilateral
// triangles.
double evenEdgeLength(double area, double vertices);
double verticesForEdgeLength(double area, double length);

}  // namespace remesher
