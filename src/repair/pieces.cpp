// SPDX-License-Identifier: MIT
#include "repair/pieces.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/place.h"
#include "geometry/ray_crossings.h"
#include "mesh/components.h"

namespace remesher {

namespace {

// Six times the volume of the tetrahedron of the triangle and `apex`.
double sixfoldVolume(const Triangle& t, const Vec3& apex) {
  return (t[0] - apex).dot((t[1] - apex).cross(t[2] - apex));
}

bool areParallel(const Triangle& s, const Triangle& t) {
  constexpr double kFlat = 0.999;  // cosine
  const Vec3 one = areaVector(s[0], s[1], s[2]), other = areaVector(t[0], t[1], t[2]);
  return std::abs(one.dot(other)) >= kFlat * one.norm() * other.norm();
}

class PieceFinder {
 public:
  PieceFinder(const BuiltMesh& built, std::span<const char> isCrossed)
      : built_(built),
        corners_(built.mesh.triangles()),
        result_{componentsOfFaces(built.mesh).of.values(), {}} {
    measure();
    for (Index f = 0; f < result_.ofFace.size(); ++f)
      if (isCrossed_[f] = isCrossed[built.triangles[Face(f)]]; isCrossed_[f])
        ++crossed_[result_.ofFace[f]];
  }

  Pieces run() {
    const std::size_t count = result_.pieces.size();
    parents_.assign(count, kNone);
    findParents();
    // Parents first: a parent's volume is larger.
    std::vector<Index> order;
    for (Index p = 0; p < count; ++p)
      if (isClosed(p)) order.push_back(p);
    std::stable_sort(order.begin(), order.end(), [&](Index p, Index q) {
      return std::abs(result_.pieces[p].volume) > std::abs(result_.pieces[q].volume);
    });
    for (const Index p : order) classify(p);
    return std::move(result_);
  }

 private:
  Triangle triangle(Index f) const {
    const Index* v = &corners_[3 * std::size_t{f}];
    return {built_.positions[Vertex(v[0])], built_.positions[Vertex(v[1])],
            built_.positions[Vertex(v[2])]};
  }

  bool isClosed(Index piece) const {
    return result_.pieces[piece].kind != SurfacePiece::Kind::Open;
  }

  void measure() {
    const std::vector<Index>& ofFace = result_.ofFace;
    const std::size_t count =
        ofFace.empty() ? 0 : 1 + *std::max_element(ofFace.begin(), ofFace.end());
    result_.pieces.assign(count, {});
    isCrossed_.assign(ofFace.size(), 0), crossed_.assign(count, 0), seeds_.assign(count, kNone);
    for (SurfacePiece& piece : result_.pieces) piece.kind = SurfacePiece::Kind::Solid;
    for (Index f = 0; f < ofFace.size(); ++f) {
      SurfacePiece& piece = result_.pieces[ofFace[f]];
      Index& seed = seeds_[ofFace[f]];
      if (seed == kNone) seed = f;
      const Triangle t = triangle(f);
      for (const Vec3& p : t) piece.box.extend(p);
      ++piece.faces;
      piece.area += area(t[0], t[1], t[2]);
      piece.isFlat = piece.isFlat && areParallel(t, triangle(seed));
      piece.volume += sixfoldVolume(t, triangle(seed)[0]) / 6;
      for (int k = 0; k < 3; ++k)
        if (built_.mesh.isBoundary(HalfedgeMesh::halfedge(Face(f), k)))
          piece.kind = SurfacePiece::Kind::Open;
    }
  }

  // Pieces that intersect others lie in none, unless they do with few faces; nor does a piece
  // alone.
  void findParents() {
    std::vector<Index> apart;
    for (Index p = 0; p < result_.pieces.size() && result_.pieces.size() > 1; ++p)
      if (isClosed(p) && crossed_[p] * crossed_[p] <= result_.pieces[p].faces) apart.push_back(p);
    if (apart.empty()) return;
    const TriangleTree tree(built_.positions.values(), corners_);
    findPoints();
    for (const Index p : apart) parents_[p] = innermostAround(p, tree);
  }

  // Of each piece a corner where no other piece is, of a face that meets none: pieces that touch
  // there hide how they lie in each other. Else the middle of a face.
  void findPoints() {
    constexpr Index kSeveral = kNone - 1;
    const std::vector<Index> place = weld(built_.positions.values());
    std::vector<Index> pieceAt(place.size(), kNone);
    for (std::size_t c = 0; c < corners_.size(); ++c) {
      Index& piece = pieceAt[place[corners_[c]]];
      const Index own = result_.ofFace[c / 3];
      if (piece != own) piece = piece == kNone ? own : kSeveral;
    }
    for (const Index seed : seeds_) {
      const Triangle t = triangle(seed);
      points_.push_back((t[0] + t[1] + t[2]) / 3);
    }
    for (std::size_t c = corners_.size(); c-- > 0;)
      if (pieceAt[place[corners_[c]]] == result_.ofFace[c / 3] && !isCrossed_[c / 3])
        points_[result_.ofFace[c / 3]] = built_.positions[Vertex(corners_[c])];
  }

  // Of the closed pieces around this one, the smallest.
  Index innermostAround(Index piece, const TriangleTree& tree) const {
    std::map<Index, int> windings;
    forEachRayCrossing(tree, points_[piece],
                       [&](Index f, int crossing) { windings[result_.ofFace[f]] += crossing; });
    Index innermost = kNone;
    const auto size = [&](Index p) { return std::abs(result_.pieces[p].volume); };
    for (const auto& [other, winding] : windings) {
      if (winding == 0 || other == piece || !isClosed(other) || size(other) <= size(piece))
        continue;
      if (innermost == kNone || size(other) < size(innermost)) innermost = other;
    }
    return innermost;
  }

  // A piece that faces against the solid that it lies in bounds a cavity. Facing as the solid does,
  // it is a shell that shows nothing, or, if it intersects others, a body of its own.
  void classify(Index p) {
    SurfacePiece& piece = result_.pieces[p];
    const SurfacePiece* const around =
        parents_[p] != kNone ? &result_.pieces[parents_[p]] : nullptr;
    const bool facesOutwards = piece.volume >= 0;
    const bool isOpposed = around != nullptr && facesOutwards != (around->volume >= 0);
    if (around == nullptr || around->kind == SurfacePiece::Kind::Cavity ||
        (crossed_[p] > 0 && !isOpposed)) {
      piece.isInsideOut = !facesOutwards;
      return;
    }
    const bool isCavity = isOpposed && around->kind == SurfacePiece::Kind::Solid;
    piece.kind = isCavity ? SurfacePiece::Kind::Cavity : SurfacePiece::Kind::Shell;
    piece.isInsideOut = around->isInsideOut;
  }

  const BuiltMesh& built_;
  const std::vector<Index> corners_;
  Pieces result_;
  std::vector<char> isCrossed_;       // per face
  std::vector<std::size_t> crossed_;  // per piece, its crossed faces
  std::vector<Index> seeds_;          // per piece its first face
  std::vector<Vec3> points_;          // per piece a point of it
  std::vector<Index> parents_;        // per piece the closed piece that it lies in
};

}  // namespace

Pieces piecesOf(const BuiltMesh& built, std::span<const char> isCrossed) {
  return PieceFinder(built, isCrossed).run();
}

}  // namespace remesher
