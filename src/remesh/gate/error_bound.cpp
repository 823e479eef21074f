// SPDX-License-Identifier: MIT
#include "remesh/gate/error_bound.h"

#include <algorithm>
#include <cmath>

#include "remesh/gate/nearness.h"

namespace remesher {

namespace {

// A proof takes a few hundred pieces.
constexpr std::size_t kMostPieces = 2'000;
// Failures that are tried first.
constexpr std::size_t kRemembered = 8;

// A short list of triangles, each in a bounding ball; the balls rule most triangles out.
class Nearby {
 public:
  void add(const Triangle& t) {
    const Piece piece(t);
    members_.push_back({t, piece.centre(), piece.radius()});
  }

  const Triangle& triangle(std::size_t member) const { return members_[member].triangle; }

  struct Nearest {
    std::size_t member = 0;
    double distance = kInfinity;
  };

  // Fastest when `start` is near.
  Nearest nearest(const Vec3& p, std::size_t start = 0) const {
    Nearest nearest{start, std::sqrt(squaredDistance(p, members_[start].triangle))};
    for (std::size_t i = 0; i < members_.size(); ++i) {
      const double reach = nearest.distance + members_[i].radius;
      if (i == start || (p - members_[i].centre).squaredNorm() >= reach * reach) continue;
      const double distance = std::sqrt(squaredDistance(p, members_[i].triangle));
      if (distance < nearest.distance) nearest = {i, distance};
    }
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

// Tests whether pieces of the original that only the going triangles may have been near are near
// the triangles that remain or come.
class NearChange {
 public:
  NearChange(const Nearby& going, const Nearby& present, double distance)
      : going_(going), present_(present), distance_(distance) {}

  std::size_t looks() const { return looks_; }

  PieceFinding operator()(const Piece& piece) {
    ++looks_;
    const double squared = distance_ * distance_;
    if (isNear(piece, present_.triangle(last_), squared)) return {Finding::Holds};
    const Vec3 centre = piece.centre();
    const double radius = piece.radius();
    const Nearby::Nearest remains = present_.nearest(centre, last_);
    const bool isOther = remains.member != last_;
    last_ = remains.member;
    if (remains.distance + radius <= distance_) return {Finding::Holds};
    if (isOther && isNear(piece, present_.triangle(last_), squared)) return {Finding::Holds};
    const double toGoing = going_.nearest(centre).distance;
    if (toGoing - radius > distance_) return {Finding::Holds};
    if (remains.distance > distance_ && toGoing <= distance_) return {Finding::Fails};
    return {Finding::Unsure, present_.triangle(last_)};
  }

 private:
  const Nearby& going_;
  const Nearby& present_;
  double distance_;
  std::size_t last_ = 0, looks_ = 0;
};

std::vector<Triangle> comingTriangles(const WorkingMesh& mesh, const LocalChange& change) {
  const auto at = [&](Vertex v) { return v == kMoved ? change.place.position : mesh.position(v); };
  std::vector<Triangle> result;
  for (const auto& [a, b, c] : change.coming) result.push_back({at(a), at(b), at(c)});
  return result;
}

// The faces that touch one of `faces` and are none of them. `faces` must be sorted.
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

}  // namespace

ErrorBound::ErrorBound(const OriginalSurface& surface, double distance)
    : distance_(distance),
      triangles_(surface.mesh().triangles()),
      tree_(surface.positions().values(), triangles_) {}

void ErrorBound::remember(const Piece& lost) const {
  if (lost_.size() < kRemembered) return lost_.push_back(lost);
  lost_[losses_] = lost;
  losses_ = (losses_ + 1) % kRemembered;
}

bool ErrorBound::keepsOriginal(const WorkingMesh& mesh, const LocalChange& change,
                               const std::vector<Triangle>& coming) const {
  std::vector<Face> faces = removedFaces(mesh.mesh(), change);
  std::sort(faces.begin(), faces.end());
  Nearby going, present;
  Box box;
  for (const Face f : faces) {
    const Triangle t = mesh.corners(f);
    going.add(t);
    for (const Vec3& p : t) box.extend(p);
  }
  for (const Triangle& t : coming) present.add(t);
  for (const Face f : facesAround(mesh.mesh(), faces)) present.add(mesh.corners(f));
  const Vec3 margin = Vec3::Constant(distance_);
  NearChange look(going, present, distance_);
  const SearchLimits limits{kSmallestPiece * distance_, kMostPieces};
  const bool isLostAgain = std::any_of(lost_.begin(), lost_.end(), [&](const Piece& piece) {
    return isFailure(piece, look(piece).finding, limits);
  });
  std::optional<Piece> lost;
  if (!isLostAgain)
    tree_.visitOverlapping({box.low - margin, box.high + margin}, [&](Index triangle) {
      if (!lost) lost = findFailure(tree_.corners(triangle), limits, look);
    });
  pieces_ += look.looks();
  if (lost) remember(*lost);
  return !isLostAgain && !lost;
}

bool ErrorBound::allows(const WorkingMesh& mesh, const LocalChange& change) const {
  if (isSpent()) return false;
  const std::vector<Triangle> coming = comingTriangles(mesh, change);
  // A collapse may change no triangle but those that vanish.
  const Face first = change.going.empty() ? HalfedgeMesh::face(change.halfedge) : change.going[0];
  const Vertex rim = mesh.mesh().vertices(first)[0];
  NearTree look(tree_, distance_, mesh.at(rim).face.index);
  const SearchLimits limits{kSmallestPiece * distance_, kMostPieces};
  const bool isNear = std::none_of(coming.begin(), coming.end(), [&](const Triangle& t) {
    return findFailure(t, limits, look).has_value();
  });
  pieces_ += look.looks();
  return isNear && keepsOriginal(mesh, change, coming);
}

}  // namespace remesher
