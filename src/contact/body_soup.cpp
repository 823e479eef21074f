// SPDX-License-Identifier: MIT
#include "contact/body_soup.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/place.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

// Grows with the angle from 0 to a full turn, without the angle itself: 0 to 4. What is turned by
// less than the tolerance counts as a full turn, for triangles back to back enclose nothing.
double turnOf(double cosine, double sine) {
  constexpr double kNoTurn = 1e-9;
  const double turn = sine >= 0 ? 1 - cosine : 3 + cosine;
  return turn < kNoTurn ? 4 : turn;
}

// Pairs the triangles at each edge so that each pair bounds the same inside.
class EdgePairing {
 public:
  EdgePairing(const std::vector<Vec3>& positions, const std::vector<Index>& corners,
              const std::vector<Index>& pieces)
      : positions_(positions), corners_(corners), pieces_(pieces) {}

  std::vector<Index> run() const {
    const EdgeGroups edges(positions_.size(), corners_);
    std::vector<Index> mates(corners_.size(), kNone);
    for (std::size_t e = 0; e < edges.size(); ++e) pair(edges[e], mates);
    return mates;
  }

 private:
  void pair(std::span<const Index> edge, std::vector<Index>& mates) const {
    struct Turned {
      double turn;
      Index h, g;
    };
    std::vector<Turned> all;
    for (const Index h : edge)
      for (const Index g : edge)
        if (corners_[h] < corners_[nextCorner(h)] && corners_[g] == corners_[nextCorner(h)] &&
            pieces_[h / 3] == pieces_[g / 3])
          all.push_back({turn(h, g), h, g});
    std::stable_sort(all.begin(), all.end(),
                     [](const Turned& a, const Turned& b) { return a.turn < b.turn; });
    for (const Turned& t : all)
      if (mates[t.h] == kNone && mates[t.g] == kNone) mates[t.h] = t.g, mates[t.g] = t.h;
  }

  // From the triangle of h to that of g through the inside of h's.
  double turn(Index h, Index g) const {
    const Vec3 &a = at(h), &b = at(nextCorner(h));
    const Vec3 edge = (b - a).normalized();
    const Vec3 own = across(h, a, edge), other = across(g, a, edge);
    return turnOf(own.dot(other), own.cross(edge).dot(other));
  }

  Vec3 across(Index h, const Vec3& from, const Vec3& edge) const {
    const Vec3 way = at(prevCorner(h)) - from;
    return (way - way.dot(edge) * edge).stableNormalized();
  }

  const Vec3& at(Index h) const { return positions_[corners_[h]]; }

  const std::vector<Vec3>& positions_;
  const std::vector<Index>& corners_;
  const std::vector<Index>& pieces_;
};

// Gives each body points of its own.
void separate(const std::vector<Vec3>& positions, BodySoup& soup) {
  std::map<std::pair<Index, Index>, Index> numbers;
  for (BodyTriangle& t : soup.triangles)
    for (Index& corner : t.corners) {
      const auto [entry, isNew] =
          numbers.emplace(std::pair(t.body, corner), Index(soup.points.size()));
      if (isNew) soup.points.push_back(positions[corner]);
      corner = entry->second;
    }
}

}  // namespace

BodySoup bodiesOf(const TriangleMesh& mesh, std::span<const Index> pieces) {
  BodySoup soup;
  const std::vector<Index> first = weld(mesh.positions);
  std::vector<Index> corners, pieceOf;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    std::array<Index, 3> c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = first[mesh.indices[3 * std::size_t{t} + k]];
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
    corners.insert(corners.end(), c.begin(), c.end());
    pieceOf.push_back(pieces[t]);
    soup.triangles.push_back({c, 0, mesh.groups.empty() ? 0 : mesh.groups[t]});
  }
  soup.mates = EdgePairing(mesh.positions, corners, pieceOf).run();
  DisjointSets sets(soup.triangles.size());
  for (Index h = 0; h < soup.mates.size(); ++h)
    if (soup.mates[h] != kNone) sets.unite(h / 3, soup.mates[h] / 3);
  std::vector<Index> numbers(soup.triangles.size(), kNone);
  for (Index t = 0; t < soup.triangles.size(); ++t) {
    Index& number = numbers[sets.find(t)];
    if (number == kNone) number = Index(soup.isClosed.size()), soup.isClosed.push_back(1);
    soup.triangles[t].body = number;
  }
  for (Index h = 0; h < soup.mates.size(); ++h)
    if (soup.mates[h] == kNone) soup.isClosed[soup.triangles[h / 3].body] = 0;
  separate(mesh.positions, soup);
  return soup;
}

}  // namespace remesher
