// SPDX-License-Identifier: MIT
#include "operators/error_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/piecewise.h"

namespace remesher {

namespace {

// Pieces that are unsure even when so small, relative to the distance, count as too far.
constexpr double kSmallest = 0.04;
// A proof takes a few hundred pieces. For the whole mesh, where one of a few large triangles may
// lie under thousands of small ones, the limit must be generous; a single change is refused
// earlier.
constexpr std::size_t kMostPieces = 100'000;
constexpr std::size_t kMostLocalPieces = 2'000;

double squaredDistance(const Vec3& p, const Triangle& t) {
  return (closestPoint(p, t[0], t[1], t[2]) - p).squaredNorm();
}

bool isNear(const Piece& piece, const Triangle& target, double squared) {
  const auto corners = piece.corners();
  return std::all_of(corners.begin(), corners.end(),
                     [&](const Vec3& p) { return squaredDistance(p, target) <= squared; });
}

// A short list of triangles, each with a ball that holds it, which rules most of them out.
class Nearby {
 public:
  struct Nearest {
    Triangle triangle = {};
    double distance = std::numeric_limits<double>::infinity();
  };

  void add(const Triangle& t) {
    const Piece piece(t);
    members_.push_back({t, piece.centre(), piece.radius()});
  }

  Nearest nearest(const Vec3& p) const {
    Nearest nearest;
    const Member* best = nullptr;
    for (const Member& member : members_) {
      const double reach = nearest.distance + member.radius;
      if ((p - member.centre).squaredNorm() >= reach * reach) continue;
      const double distance = std::sqrt(squaredDistance(p, member.triangle));
      if (distance >= nearest.distance) continue;
      nearest.distance = distance;
      best = &member;
    }
    if (best) nearest.triangle = best->triangle;
    return nearest;
  }

 private:
  struct Member {
    Triangle triangle;
    Vec3 centre;
    double radius;
  };
  std::vector<Member> members_;
};

Triangle cornersOf(const WorkingMesh& mesh, Face f) {
  const auto [a, b, c] = mesh.mesh().vertices(f);
  return {mesh.position(a), mesh.position(b), mesh.position(c)};
}

// Looks whether pieces of one surface are near the triangles of another. Pieces come in an order
// along which they are close to each other, so the last nearest triangle is where to begin.
class NearTree {
 public:
  NearTree(const TriangleTree& tree, double distance, Index start = 0)
      : tree_(tree), distance_(distance), last_(start) {}

  Look operator()(const Piece& piece) {
    const double squared = distance_ * distance_;
    if (isNear(piece, tree_.corners(last_), squared)) return {Finding::Holds};
    const TriangleTree::Nearest nearest = tree_.nearest(piece.centre(), last_);
    const bool isOther = nearest.triangle != last_;
    last_ = nearest.triangle;
    if (nearest.squaredDistance > squared) return {Finding::Fails};
    if (isOther && isNear(piece, tree_.corners(last_), squared)) return {Finding::Holds};
    if (std::sqrt(nearest.squaredDistance) + piece.radius() <= distance_) return {Finding::Holds};
    return {Finding::Unsure, tree_.corners(last_)};
  }

 private:
  const TriangleTree& tree_;
  double distance_;
  Index last_;
};

// Looks whether pieces of the original that only the going triangles may have been near are near
// those that remain or come.
struct NearChange {
  const Nearby& going;
  const Nearby& present;
  double distance;

  Look operator()(const Piece& piece) const {
    const Vec3 centre = piece.centre();
    const double radius = piece.radius();
    const double toGoing = going.nearest(centre).distance;
    if (toGoing - radius > distance) return {Finding::Holds};
    const Nearby::Nearest remains = present.nearest(centre);
    if (remains.distance + radius <= distance) return {Finding::Holds};
    if (isNear(piece, remains.triangle, distance * distance)) return {Finding::Holds};
    if (remains.distance > distance && toGoing <= distance) return {Finding::Fails};
    return {Finding::Unsure, remains.triangle};
  }
};

std::vector<Triangle> comingTriangles(const WorkingMesh& mesh, const LocalChange& change) {
  const auto at = [&](Vertex v) { return v == kMoved ? change.place.position : mesh.position(v); };
  std::vector<Triangle> result;
  for (const auto& [a, b, c] : change.coming) result.push_back({at(a), at(b), at(c)});
  return result;
}

// The faces that go: those the proposal names, and with a collapse those of the edge itself.
std::vector<Face> goingFaces(const HalfedgeMesh& mesh, const LocalChange& change) {
  std::vector<Face> faces = change.going;
  if (change.operation == Operation::Collapse)
    for (const Halfedge h : {change.halfedge, mesh.twin(change.halfedge)})
      if (h) faces.push_back(HalfedgeMesh::face(h));
  std::sort(faces.begin(), faces.end());
  return faces;
}

// The faces that touch one of `faces` and are none of them, which are in order.
std::vector<Face> facesAround(const HalfedgeMesh& mesh, const std::vector<Face>& faces) {
  std::vector<Face> around;
  for (const Face f : faces)
    for (const Vertex v : mesh.vertices(f))
      mesh.forEachOutgoing(v, [&](Halfedge h) {
        const Face face = HalfedgeMesh::face(h);
        if (!std::binary_search(faces.begin(), faces.end(), face)) around.push_back(face);
      });
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  return around;
}

std::vector<Face> aliveFaces(const HalfedgeMesh& mesh) {
  std::vector<Face> faces;
  for (Index f = 0; f < mesh.faceCapacity(); ++f)
    if (mesh.isAlive(Face(f))) faces.push_back(Face(f));
  return faces;
}

}  // namespace

ErrorBound::ErrorBound(const OriginalSurface& surface, double distance)
    : distance_(distance),
      triangles_(surface.mesh().triangles()),
      tree_(surface.positions().values(), triangles_) {}

bool ErrorBound::keepsOriginal(const WorkingMesh& mesh, const LocalChange& change,
                               const std::vector<Triangle>& coming) const {
  const std::vector<Face> faces = goingFaces(mesh.mesh(), change);
  Nearby going, present;
  Box box;
  for (const Face f : faces) {
    const Triangle t = cornersOf(mesh, f);
    going.add(t);
    for (const Vec3& p : t) box.extend(p);
  }
  for (const Triangle& t : coming) present.add(t);
  for (const Face f : facesAround(mesh.mesh(), faces)) present.add(cornersOf(mesh, f));
  const Vec3 margin = Vec3::Constant(distance_);
  const NearChange look{going, present, distance_};
  bool kept = true;
  tree_.visitOverlapping({box.low - margin, box.high + margin}, [&](Index triangle) {
    kept = kept &&
           !findFailure(tree_.corners(triangle), {kSmallest * distance_, kMostLocalPieces}, look);
  });
  return kept;
}

bool ErrorBound::allows(const WorkingMesh& mesh, const LocalChange& change) const {
  const std::vector<Triangle> coming = comingTriangles(mesh, change);
  const Vertex rim = mesh.mesh().vertices(change.going[0])[0];
  NearTree look(tree_, distance_, mesh.at(rim).face.index);
  for (const Triangle& t : coming)
    if (findFailure(t, {kSmallest * distance_, kMostLocalPieces}, look)) return false;
  return keepsOriginal(mesh, change, coming);
}

ErrorBound::Excess ErrorBound::excess(const WorkingMesh& mesh) const {
  const SearchLimits limits{kSmallest * distance_, kMostPieces};
  Excess result;
  const std::vector<Face> faces = aliveFaces(mesh.mesh());
  const std::vector<Index> triangles = mesh.mesh().triangles();
  const TriangleTree tree(mesh.positions().values(), triangles);
  NearTree toOriginal(tree_, distance_), toMesh(tree, distance_);
  for (const Index t : tree.order())
    if (findFailure(tree.corners(t), limits, toOriginal)) result.stray.push_back(faces[t]);
  std::sort(result.stray.begin(), result.stray.end());

  for (const Index t : tree_.order()) {
    const Triangle whole = tree_.corners(t);
    const auto failure = findFailure(whole, limits, toMesh);
    if (!failure) continue;
    Lost lost;
    for (const Vec3& p : {*failure, whole[0], whole[1], whole[2]}) {
      const TriangleTree::Nearest nearest = tree.nearest(p);
      if (nearest.squaredDistance <= lost.distance) continue;
      const Vec3 weights = closestBarycentric(p, whole[0], whole[1], whole[2]);
      lost = {{Face(t), weights}, faces[nearest.triangle], nearest.squaredDistance};
    }
    lost.distance = std::sqrt(lost.distance);
    if (lost.nearest) result.lost.push_back(lost);
  }
  std::stable_sort(result.lost.begin(), result.lost.end(),
                   [](const Lost& a, const Lost& b) { return a.distance > b.distance; });
  return result;
}

}  // namespace remesher
