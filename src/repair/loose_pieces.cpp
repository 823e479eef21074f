// SPDX-License-Identifier: MIT
#include "repair/loose_pieces.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/disjoint_sets.h"
#include "base/place.h"
#include "geometry/triangle.h"
#include "geometry/triangle_tree.h"

namespace remesher {

namespace {

// Squared lengths of copies of a piece, turned anyhow and rounded, differ by less.
constexpr double kEqual = 5e-4;

bool areNear(double a, double b) { return std::max(a, b) <= (1 + kEqual) * std::min(a, b); }

}  // namespace

LoosePieces::LoosePieces(std::span<const Vec3> positions, std::span<const Index> corners)
    : positions_(positions), corners_(corners) {
  const std::vector<Index> first = weld(positions);
  DisjointSets sets(positions.size());
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    sets.unite(first[corners[i]], first[corners[i + 1]]);
    sets.unite(first[corners[i]], first[corners[i + 2]]);
  }
  std::vector<Index> numbers(positions.size(), kNone);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    Index& number = numbers[sets.find(first[corners[i]])];
    if (number == kNone) {
      number = Index(pieces_.size());
      pieces_.emplace_back();
    }
    LoosePiece& piece = pieces_[number];
    const Vec3 &a = positions[corners[i]], &b = positions[corners[i + 1]],
               &c = positions[corners[i + 2]];
    for (const Vec3* p : {&a, &b, &c}) piece.box.extend(*p);
    piece.area += area(a, b, c);
    piece.edges += (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    ++piece.triangles;
    ofTriangles_.push_back(number);
  }
}

double LoosePieces::diagonal() const {
  Box box;
  for (const LoosePiece& piece : pieces_) box.extend(piece.box.low), box.extend(piece.box.high);
  return pieces_.empty() ? 0 : (box.high - box.low).norm();
}

std::vector<char> LoosePieces::smallerThan(double share) const {
  const double least = share * diagonal();
  std::vector<char> isSmall;
  for (const LoosePiece& piece : pieces_) isSmall.push_back(char(piece.across() < least));
  return isSmall;
}

std::vector<char> LoosePieces::floaters() const {
  constexpr double kSmall = 0.03, kMostArea = 0.05;
  std::vector<char> isSmall = smallerThan(kSmall);
  double all = 0, small = 0;
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    all += pieces_[p].area;
    if (isSmall[p]) small += pieces_[p].area;
  }
  if (small > kMostArea * all) return std::vector<char>(pieces_.size(), 0);
  keepThreeOfAKind(isSmall);
  keepAttached(isSmall);
  return isSmall;
}

void LoosePieces::keepThreeOfAKind(std::vector<char>& isSmall) const {
  constexpr std::size_t kKind = 3;
  std::map<std::size_t, std::vector<std::pair<double, std::size_t>>> byTriangles;
  for (std::size_t p = 0; p < pieces_.size(); ++p)
    if (isSmall[p]) byTriangles[pieces_[p].triangles].emplace_back(pieces_[p].area, p);
  for (auto& [triangles, byArea] : byTriangles) {
    std::sort(byArea.begin(), byArea.end());
    for (const auto& [own, piece] : byArea) {
      std::size_t alike = 0;  // the piece itself among them
      for (auto other = std::lower_bound(byArea.begin(), byArea.end(),
                                         std::pair(own / (1 + kEqual), std::size_t{0}));
           other != byArea.end() && other->first <= (1 + kEqual) * own && alike < kKind; ++other)
        alike += areNear(pieces_[piece].edges, pieces_[other->second].edges) ? 1 : 0;
      if (alike == kKind) isSmall[piece] = 0;
    }
  }
}

// A piece that touches a larger one, or nearly so, belongs to it.
void LoosePieces::keepAttached(std::vector<char>& isSmall) const {
  constexpr double kNear = 0.05;  // of its own size
  std::vector<Index> large;
  for (std::size_t t = 0; t < ofTriangles_.size(); ++t)
    if (!isSmall[ofTriangles_[t]])
      large.insert(large.end(), corners_.begin() + std::ptrdiff_t(3 * t),
                   corners_.begin() + std::ptrdiff_t(3 * t + 3));
  if (large.empty()) return;
  const TriangleTree tree(positions_, large);
  std::vector<char> isAttached(pieces_.size(), 0);
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Index piece = ofTriangles_[i / 3];
    if (!isSmall[piece] || isAttached[piece]) continue;
    const double distance = std::sqrt(tree.nearest(positions_[corners_[i]]).squaredDistance);
    isAttached[piece] = char(distance <= kNear * pieces_[piece].across());
  }
  for (std::size_t p = 0; p < pieces_.size(); ++p)
    if (isAttached[p]) isSmall[p] = 0;
}

}  // namespace remesher
