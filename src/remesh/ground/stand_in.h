// SPDX-License-Identifier: MIT
// A large original costs at every step, though coarse triangles do not care for detail a hundredth
// of their edges. So a thinned copy of it, whose vertices know their places on the original, stands
// in for it until the mesh lands on the original itself.
#pragma once

#include "original/surface/original_surface.h"

namespace remesher {

// A part of the original's vertices, how they hang together, and which of them each has gone into.
struct Thinned {
  const HalfedgeMesh* mesh;
  const VertexData<Vertex>* onOriginal;
  const VertexData<Vertex>* heirs;
};

class StandIn {
 public:
  // `original` must outlive the stand-in. edge: how long, about, its edges are; model units.
  StandIn(const OriginalSurface& original, double edge);

  const OriginalSurface& surface() const { return surface_; }
  const OriginalSurface& original() const { return *original_; }

  // Where a vertex of the stand-in lies on the original.
  Vertex onOriginal(Vertex v) const { return onOriginal_[v]; }
  // The point of the original that is nearest to one of the stand-in.
  SurfacePoint onOriginal(const SurfacePoint& p) const;
  // Per vertex of the original the one of the stand-in that it went into.
  const VertexData<Vertex>& heirs() const { return heirs_; }
  Thinned thinned() const { return {&surface_.mesh(), &onOriginal_, &heirs_}; }

 private:
  struct Parts;
  StandIn(const OriginalSurface& original, Parts&& thinned);

  const OriginalSurface* original_;
  VertexData<Vertex> heirs_;
  VertexData<Vertex> onOriginal_;
  OriginalSurface surface_;
};

}  // namespace remesher
