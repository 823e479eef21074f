// SPDX-License-Identifier: MIT
// The connected pieces of a bag of triangles by size, and which of them are small.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/types.h"
#include "geometry/box.h"

namespace remesher {

struct LoosePiece {
  Box box;
  double area = 0;
  double edges = 0;  // the sum of their squared lengths, each counted once for each triangle
  std::size_t triangles = 0;

  double across() const { return (box.high - box.low).norm(); }
};

// Triangles with corners at one place are of one piece. Positions and corners must outlive it.
class LoosePieces {
 public:
  LoosePieces(std::span<const Vec3> positions, std::span<const Index> corners);

  const std::vector<Index>& ofTriangles() const { return ofTriangles_; }
  const std::vector<LoosePiece>& all() const { return pieces_; }

  // Per piece whether it is less across than this share of the diagonal.
  std::vector<char> smallerThan(double share) const;

  // Per piece whether it is a floater, as generators of models leave them: it is small, touches
  // nothing larger, and there are no three of its kind, as of rivets. Where much of the surface is
  // in small pieces none is.
  std::vector<char> floaters() const;

 private:
  double diagonal() const;
  void keepThreeOfAKind(std::vector<char>& isSmall) const;
  void keepAttached(std::vector<char>& isSmall) const;

  std::span<const Vec3> positions_;
  std::span<const Index> corners_;
  std::vector<Index> ofTriangles_;
  std::vector<LoosePiece> pieces_;  // in the order of their first triangles
};

}  // namespace remesher
