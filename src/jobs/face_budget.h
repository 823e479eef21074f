// SPDX-License-Identifier: MIT
// A budget in triangles, or in quads: the number of vertices whose result has that many faces, or
// as many fewer as the surface asks for. A budget too small for the corners of a part is raised.
#pragma once

#include <cstddef>

#include "base/part_options.h"
#include "base/progress.h"
#include "base/report.h"
#include "base/triangle_mesh.h"
#include "mesh/welding.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

// How many faces a result has: quads where it is of quads, else triangles.
std::size_t facesOf(const MeshReport& report);

// The number of vertices of so many faces on a surface like the input, by its Euler characteristic
// and its open edges, whose number goes with the square root of the faces. At least 1.
Index verticesFor(Index faces, const PartOptions& options, const MeshReport& input);

// Searches the number of vertices whose result has the wanted number of faces. A vertex more is two
// triangles more, or one quad; how many vertices lie on boundaries is known only of results.
class FaceSearch {
 public:
  FaceSearch(const PartOptions& options, const MeshReport& input);

  // The number of vertices to try next.
  Index vertices() const { return next_; }

  // Takes note of that result. Returns whether it is the best so far.
  bool take(const MeshReport& made);

  // Whether no further result can be expected to come nearer.
  bool isSettled() const { return isSettled_; }

 private:
  bool isBetter(std::size_t faces) const;

  std::size_t budget_;
  bool areQuads_;
  double facesPerVertex_;
  std::size_t closeEnough_;  // so many faces fewer than the budget are no reason to go on
  Index next_;
  std::size_t best_ = 0;  // faces of the best result; 0: none yet
  int tries_ = 0;
  int beyond_ = 0;  // results with more faces than the budget
  bool isSettled_ = false;
};

// Whether the number of vertices is a budget, of faces or as a share of the input's, that the
// surface may raise: not that of a level of detail.
bool isBudget(const PartOptions& options);

// The corners of a part that is made of facets; 0 of other surfaces, and where features are off.
std::size_t cornersOfPart(const TriangleMesh& input, const PartOptions& options);

// Remeshes within a budget. Where that visibly dents a part with more corners, but few of them, it
// has as many vertices as corners: MORE_VERTICES_TAKEN. Throws the Errors of remeshSurface.
RemeshOutcome remeshToBudget(const TriangleMesh& input, Welding welding, const PartOptions& options,
                             const Progress& progress);

}  // namespace remesher
