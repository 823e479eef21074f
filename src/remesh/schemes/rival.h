// SPDX-License-Identifier: MIT
// Chooses between even triangles and the vertices of the original that its shape needs most.
#pragma once

#include <optional>

#include "remesh/operators/working_mesh.h"
#include "remesh/schemes/follow.h"
#include "remesh/schemes/plan.h"

namespace remesher {

// The largest distance that is not seen, as a share of the diagonal: half a pixel in a picture a
// thousand pixels wide.
constexpr double kSeen = 5e-4;

// The mesh that `follow` makes of an original. It is taken if even triangles are visibly away from
// the original and it is much nearer, or if even triangles cannot be so few. Made on first use.
class Rival {
 public:
  Rival(const Prepared& original, const TriangleMesh& input, Textures textures);

  // Whether even triangles have lost before they are finished.
  bool hasWon(const WorkingMesh& even);

  // The mesh to take instead of the even triangles, if any.
  std::optional<Followed> winner(const WorkingMesh& even, bool isReached);

 private:
  bool isOwn();
  bool hasFlats();
  Away awayOf(const WorkingMesh& even);
  double muchNearer() const;  // the factor at which even triangles lose
  void look();

  const Prepared& original_;
  const TriangleMesh& input_;
  Textures textures_;
  bool isPlain_;   // no textures, no colours, no second group
  double unseen_;  // what is nowhere seen, and what is not seen over an area
  double seen_;
  std::optional<bool> isOwn_, hasFlats_;
  bool isSettled_ = false, hasLooked_ = false;
  std::optional<Followed> followed_;
};

}  // namespace remesher
