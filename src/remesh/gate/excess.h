// SPDX-License-Identifier: MIT
// Finds where a mesh leaves an error bound, or proves that it does not. Made for repeated queries
// while the mesh is mended.
#pragma once

#include <optional>
#include <vector>

#include "remesh/gate/error_bound.h"
#include "remesh/gate/nearness.h"

namespace remesher {

// A place of the original that is too far from the mesh, or cannot be proven to be near.
struct Lost {
  SurfacePoint place;
  double distance = 0;
};

struct Excess {
  std::vector<Face> stray;  // triangles of the mesh too far from the original
  std::vector<Lost> lost;   // the farthest first

  bool empty() const { return stray.empty() && lost.empty(); }
};

class ExcessSearch {
 public:
  // `bound` must outlive the search.
  explicit ExcessSearch(const ErrorBound& bound);

  // Where the mesh leaves the bound; empty if it provably does not. Parts unchanged since the last
  // call are not looked at again.
  Excess find(const WorkingMesh& mesh);

 private:
  struct Seen {
    std::optional<Triangle> corners;  // none if the face is not alive
    bool isStray = false;
  };

  bool isStray(const WorkingMesh& mesh, Face f) const;
  std::vector<Face> findStray(const WorkingMesh& mesh);
  std::vector<Lost> findLost(const WorkingMesh& mesh);
  void doubtAround(const Triangle& gone);

  const ErrorBound& bound_;
  SearchLimits limits_;
  std::vector<Seen> seen_;        // per face of the mesh, at the last call
  std::vector<char> isDoubtful_;  // per triangle of the original: must it be looked at?
};

}  // namespace remesher
