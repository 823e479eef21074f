// SPDX-License-Identifier: MIT
// A bound on the distance between the mesh and the original, in both directions, kept by every
// change that is allowed.
#pragma once

#include <limits>
#include <vector>

#include "geometry/piecewise.h"
#include "geometry/triangle_tree.h"
#include "remesh/operators/local_change.h"

namespace remesher {

class ErrorBound {
 public:
  // distance: model units. `surface` must outlive the bound.
  ErrorBound(const OriginalSurface& surface, double distance);

  // Whether a mesh within the bound stays within it: the coming triangles are near the original,
  // and every part of the original that only the going triangles may have been near is near the
  // coming triangles or those around them.
  bool allows(const WorkingMesh& mesh, const LocalChange& change) const;

  // Limits the work of proofs: from now on about `pieces` pieces may be looked at; then nothing is
  // allowed.
  void grant(std::size_t pieces) const { most_ = pieces_ + pieces; }
  bool isSpent() const { return pieces_ >= most_; }
  std::size_t piecesLookedAt() const { return pieces_; }

  double distance() const { return distance_; }
  const TriangleTree& original() const { return tree_; }

 private:
  bool keepsOriginal(const WorkingMesh& mesh, const LocalChange& change,
                     const std::vector<Triangle>& coming) const;
  void remember(const Piece& lost) const;

  double distance_;
  std::vector<Index> triangles_;
  TriangleTree tree_;
  mutable std::size_t pieces_ = 0, most_ = std::numeric_limits<std::size_t>::max();
  // Pieces of the original where recent proofs failed: the next change, mostly of the same star, is
  // likely to fail there too.
  mutable std::vector<Piece> lost_;
  mutable std::size_t losses_ = 0;
};

}  // namespace remesher
