// SPDX-License-Identifier: MIT
// Chooses between even triangles and the original simplified to the vertices that its shape needs
// most.
#pragma once

#include <optional>

#include "remesh/operators/working_mesh.h"
#include "remesh/schemes/follow.h"
#include "remesh/schemes/plan.h"

namespace remesher {

// The largest distance that is not seen, as a share of the diagonal: half a pixel in a picture a
// thousand pixels wide. With twice as much 119 of 119 results (17 cases at 7 neighboring counts)
// are the same, with half as much 102, and angles 4.3° smaller, means of medians.
constexpr double kSeen = 5e-4;

// The mesh that `follow` makes of an original, made on first use. It replaces even triangles that
// are visibly away from the original, if it is much nearer, or that miss the number asked for.
class Rival {
 public:
  Rival(const Prepared& original, const TriangleMesh& input, Textures textures);

  // Whether the rival has won before the even triangles are finished.
  bool hasWon(const WorkingMesh& even);

  // Whether even triangles may miss the shape without a rival: there is none with more vertices
  // than the original has. Flat sides show a miss.
  bool mayMiss();
  // Whether such triangles are visibly away, if they may miss it.
  bool isMissedBy(const WorkingMesh& even);

  // The mesh to take instead of the even triangles, if any.
  std::optional<Followed> winner(const WorkingMesh& even, bool isReached);

 private:
  bool isOwn();
  bool hasEnough();
  bool hasFlats();
  Away awayOf(const WorkingMesh& even);
  double muchNearer();  // how many times nearer the rival must be
  void look();

  const Prepared& original_;
  const TriangleMesh& input_;
  Textures textures_;
  bool isPlain_;   // no textures, no colours, no second group
  double unseen_;  // the largest distance at any one place that is not seen, model units
  double seen_;    // the largest RMS distance that is not seen
  std::optional<bool> isOwn_, hasEnough_, hasFlats_;
  bool isSettled_ = false, hasLooked_ = false;
  std::optional<Followed> followed_;
};

}  // namespace remesher
