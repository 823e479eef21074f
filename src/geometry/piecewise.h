// SPDX-License-Identifier: MIT
// Decides whether something holds at every point of a triangle: the triangle is cut into pieces
// until each piece can be decided as a whole.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/triangle.h"

namespace remesher {

// A convex part of a triangle.
class Piece {
 public:
  static constexpr std::size_t kMostCorners = 10;

  Piece() { corners_.fill(Vec3::Zero()); }
  explicit Piece(const Triangle& t);

  std::span<const Vec3> corners() const { return {corners_.data(), count_}; }
  void add(const Vec3& p) { corners_[count_++] = p; }
  Vec3 centre() const;
  double radius() const;  // of the smallest ball around the centre that holds the piece

 private:
  std::array<Vec3, kMostCorners> corners_;
  std::size_t count_ = 0;
};

enum class Finding { Holds, Fails, Unsure };

// What holds of a piece. If unsure, cutter is the triangle over which to cut the piece.
struct PieceFinding {
  Finding finding = Finding::Unsure;
  Triangle cutter = {};
};

struct SearchLimits {
  double smallest = 0;         // an unsure piece of this radius or less fails
  std::size_t mostPieces = 0;  // after this many pieces the next undecided one fails
};

// Cuts a piece into the part over a triangle and the parts beyond its sides; false if nothing wider
// than `least` can be cut off.
bool cutOver(const Piece& piece, const Triangle& over, double least, std::vector<Piece>& parts);

void halve(const Piece& piece, std::vector<Piece>& parts);

// Cuts a piece over a triangle or, if that cannot be, halves it.
void cut(const Piece& piece, const Triangle& over, double least, std::vector<Piece>& parts);

// Whether a piece ends the search.
inline bool isFailure(const Piece& piece, Finding finding, const SearchLimits& limits) {
  return finding == Finding::Fails ||
         (finding == Finding::Unsure && piece.radius() <= limits.smallest);
}

// look: takes a piece and returns a PieceFinding. Returns a piece that fails, if any.
template <class Looking>
std::optional<Piece> findFailure(const Triangle& whole, const SearchLimits& limits,
                                 Looking&& look) {
  std::vector<Piece> pending = {Piece(whole)};
  for (std::size_t pieces = 0; !pending.empty(); ++pieces) {
    const Piece piece = pending.back();
    pending.pop_back();
    const auto [finding, cutter] = look(piece);
    if (finding == Finding::Holds) continue;
    if (isFailure(piece, finding, limits) || pieces >= limits.mostPieces) return piece;
    cut(piece, cutter, limits.smallest, pending);
  }
  return {};
}

}  // namespace remesher
