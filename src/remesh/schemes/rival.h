// SPDX-License-Identifier: MIT
// Even triangles against those vertices of the original that its shape needs: which are taken.
#pragma once

#include <optional>

#include "remesh/operators/working_mesh.h"
#include "remesh/schemes/follow.h"
#include "remesh/schemes/plan.h"

namespace remesher {

// What is no farther away is not seen: half a pixel in a picture a thousand pixels wide, as a share
// of the diagonal.
constexpr double kSeen = 5e-4;

// What `follow` makes of an original: taken where even triangles are visibly away from it and these
// much nearer, or where even triangles cannot be so few. Made when it is first asked for.
class Rival {
 public:
  Rival(const Prepared& original, const TriangleMesh& input, Textures textures);

  // Whether even triangles that are not finished yet have lost.
  bool hasWon(const WorkingMesh& even);

  // What is taken, if not the even triangles.
  std::optional<Followed> winner(const WorkingMesh& even, bool isReached);

 private:
  double distanceOf(const WorkingMesh& even);
  void lookForFlats();
  double muchNearer() const;  // times, for even triangles to lose
  void look();

  const Prepared& original_;
  const TriangleMesh& input_;
  Textures textures_;
  bool isPlain_;  // nothing is drawn on it
  double seen_;   // what is no farther is not seen
  bool isSettled_ = false, hasLooked_ = false, hasLookedForFlats_ = false;
  std::optional<Followed> followed_;
};

}  // namespace remesher
