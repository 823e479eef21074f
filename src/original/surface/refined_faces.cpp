// SPDX-License-Identifier: MIT
#include "original/surface/refined_faces.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/fires.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

// Pieces of needles, which may be 1e12 times as long as the sizes, besides those of even faces.
constexpr double kMostPieces = 0x1p18, kMostPiecesPerFace = 0x1p10, kPiecesPerArea = 16;

// Halved, a needle becomes three of half its length.
double piecesOf(double length, double longest) {
  double pieces = 1;
  for (; length > longest && pieces < kInfinity; length /= 2) pieces *= 3;
  return pieces;
}

}  // namespace

class RefinedFaces::Builder {
 public:
  Builder(const OriginalSurface& surface, double longest, RefinedFaces& faces)
      : surface_(surface), longest_(longest), faces_(faces) {}

  void run() {
    faces_.positions_ = surface_.positions();
    for (Index f = 0; f < surface_.mesh().faceCapacity(); ++f) addFace(Face(f));
    boundPieces();
    // The list grows during the loop.
    for (Index i = 0; i < faces_.nodes_.size(); ++i) halve(i);
    collect();
  }

 private:
  void addFace(Face f) {
    const HalfedgeMesh& mesh = surface_.mesh();
    Node node;
    node.corners = mesh.vertices(f);
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = HalfedgeMesh::halfedge(f, k);
      const bool own = surface_.isFlat(f);
      const bool other = mesh.isBoundary(h) ? own : surface_.isFlat(mesh.face(mesh.twin(h)));
      node.isFlat[k] = own || other;
      node.isInner[k] = own && other;
    }
    faces_.nodes_.push_back(node);
    faces_.owners_.push_back(f);
  }

  double length(const Node& node, int side) const {
    return distance(faces_.positions_[node.corners[side]],
                    faces_.positions_[node.corners[(side + 1) % 3]]);
  }

  // Longer edges stay where there would be too many pieces.
  void boundPieces() {
    while (hasTooMany()) {
      fires("refined faces: sides are too long for the sizes");
      longest_ *= 2;
    }
  }

  bool hasTooMany() const {
    double pieces = 0, sum = 0;
    for (const Node& node : faces_.nodes_) {
      double own = 0;
      for (int k = 0; k < 3; ++k)
        if (node.isFlat[k]) own = std::max(own, length(node, k));
      pieces += piecesOf(own, longest_);
      const auto& [a, b, c] = node.corners;
      sum += area(faces_.positions_[a], faces_.positions_[b], faces_.positions_[c]);
    }
    const double most = kMostPieces + kMostPiecesPerFace * double(faces_.nodes_.size());
    return longest_ > 0 && pieces > most + kPiecesPerArea * sum / (longest_ * longest_);
  }

  // Both faces of an edge that is too long halve it sooner or later, so the result has no
  // T-junctions.
  void halve(Index i) {
    Node node = faces_.nodes_[i];
    double longest = longest_;
    int side = -1;
    for (int k = 0; k < 3; ++k) {
      if (!node.isFlat[k] || length(node, k) <= longest) continue;
      longest = length(node, k);
      side = k;
    }
    if (side < 0) return;
    const int next = (side + 1) % 3, last = (side + 2) % 3;
    node.side = side;
    node.middle = middleOf(node, side);
    node.first = Index(faces_.nodes_.size());
    faces_.nodes_[i] = node;
    const Face owner = faces_.owners_[i];
    const bool isFlat = surface_.isFlat(owner);
    // The new side runs from the middle to the last corner.
    Node before = node, after = node;
    before.corners[next] = after.corners[side] = node.middle;
    before.isFlat[next] = after.isFlat[last] = isFlat;
    before.isInner[next] = after.isInner[last] = isFlat;
    for (const Node& half : {before, after}) {
      faces_.nodes_.push_back(half);
      faces_.nodes_.back().first = kNone;
      faces_.owners_.push_back(owner);
    }
  }

  Vertex middleOf(const Node& node, int side) {
    const Vertex a = node.corners[side], b = node.corners[(side + 1) % 3];
    const auto [found, isNew] = known_.try_emplace(std::minmax(a, b), Vertex());
    if (isNew) {
      found->second = Vertex(Index(faces_.positions_.size()));
      faces_.positions_.values().push_back(0.5 * (faces_.positions_[a] + faces_.positions_[b]));
      faces_.middles_.push_back({{a, b}, node.isInner[side] != 0});
    }
    return found->second;
  }

  // Edges and areas of the triangles that are not halved.
  void collect() {
    faces_.areas_.assign(faces_.positions_.size(), 0);
    for (const Node& node : faces_.nodes_) {
      if (node.first != kNone) continue;
      const auto& [a, b, c] = node.corners;
      const double third =
          area(faces_.positions_[a], faces_.positions_[b], faces_.positions_[c]) / 3;
      for (int k = 0; k < 3; ++k) {
        faces_.areas_[node.corners[k]] += third;
        faces_.edges_.push_back(std::minmax(node.corners[k], node.corners[(k + 1) % 3]));
      }
    }
    auto& edges = faces_.edges_;
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  }

  const OriginalSurface& surface_;
  double longest_;
  RefinedFaces& faces_;
  std::map<std::pair<Vertex, Vertex>, Vertex> known_;
};

RefinedFaces::RefinedFaces(const OriginalSurface& surface, double longest) {
  Builder(surface, longest, *this).run();
}

VertexData<double> RefinedFaces::leastAround(const FaceData<double>& values) const {
  VertexData<double> least(positions_.size(), kInfinity);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].first == kNone)
      for (const Vertex v : nodes_[i].corners) least[v] = std::min(least[v], values[owners_[i]]);
  return least;
}

double RefinedFaces::interpolate(const SurfacePoint& p, const VertexData<double>& values) const {
  const Node* node = &nodes_[p.face.index];
  Vec3 weights = p.barycentric;
  while (node->first != kNone) {
    const int side = node->side, next = (side + 1) % 3;
    const bool isBefore = weights[side] >= weights[next];
    const int kept = isBefore ? side : next, other = isBefore ? next : side;
    // The middle replaces the farther end, with twice that end's weight.
    weights[kept] -= weights[other];
    weights[other] *= 2;
    node = &nodes_[node->first + (isBefore ? 0 : 1)];
  }
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += weights[k] * values[node->corners[k]];
  return sum;
}

}  // namespace remesher
