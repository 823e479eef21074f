// SPDX-License-Identifier: MIT
// A bound on the distance between the mesh and the original, in both directions: proven for a whole
// mesh, and kept by every change that is allowed.
//
// What is used throughout: the distance to a triangle is a convex function, so a piece whose three
// corners are near one triangle is near it everywhere; and the distance to anything changes by no
// more than the way between two points.
#pragma once

#include <vector>

#include "geometry/triangle_tree.h"
#include "operators/local_change.h"

namespace remesher {

class ErrorBound {
 public:
  // distance: model units. `surface` must outlive the bound.
  ErrorBound(const OriginalSurface& surface, double distance);

  // Whether a mesh that is within the bound remains so: the coming triangles are near the original,
  // and whatever of the original may have been near the going ones only is near the coming ones or
  // those around.
  bool allows(const WorkingMesh& mesh, const LocalChange& change) const;

  // A place of the original that is too far from the mesh, or cannot be proven not to be.
  struct Lost {
    SurfacePoint place;
    Face nearest;  // of the mesh
    double distance = 0;
  };

  // Where a mesh leaves the bound; nothing if it is proven not to.
  struct Excess {
    std::vector<Face> stray;  // triangles of the mesh too far from the original
    std::vector<Lost> lost;   // the farthest first

    bool empty() const { return stray.empty() && lost.empty(); }
  };
  Excess excess(const WorkingMesh& mesh) const;

 private:
  bool keepsOriginal(const WorkingMesh& mesh, const LocalChange& change,
                     const std::vector<Triangle>& coming) const;

  double distance_;
  std::vector<Index> triangles_;
  TriangleTree tree_;
};

}  // namespace remesher
