// SPDX-License-Identifier: MIT
// A large original slows every step, though coarse triangles need no detail of a hundredth of their
// edges. So the steps use a proxy: a decimated copy, whose vertices know their places on the
// original. Near the end the mesh is reprojected onto the original.
#pragma once

#include "original/surface/original_surface.h"

namespace remesher {

// A mesh of a part of the original's vertices, their numbers on the original, and the collapse map:
// per vertex of the original the one of them that it was collapsed into.
struct Thinned {
  const HalfedgeMesh* mesh;
  const VertexData<Vertex>* onOriginal;
  const VertexData<Vertex>* collapseMap;
};

class Proxy {
 public:
  // `original` must outlive the proxy. edge: the approximate length of its edges, model units.
  Proxy(const OriginalSurface& original, double edge);

  const OriginalSurface& surface() const { return surface_; }
  const OriginalSurface& original() const { return *original_; }

  // The original's vertex at a vertex of the proxy.
  Vertex onOriginal(Vertex v) const { return onOriginal_[v]; }
  // The point of the original that is nearest to one of the proxy.
  SurfacePoint onOriginal(const SurfacePoint& p) const;
  // Per vertex of the original the vertex of the proxy that it was collapsed into.
  const VertexData<Vertex>& collapseMap() const { return collapseMap_; }
  Thinned thinned() const { return {&surface_.mesh(), &onOriginal_, &collapseMap_}; }

 private:
  struct Parts;
  Proxy(const OriginalSurface& original, Parts&& thinned);

  const OriginalSurface* original_;
  VertexData<Vertex> collapseMap_;
  VertexData<Vertex> onOriginal_;
  OriginalSurface surface_;
};

}  // namespace remesher
