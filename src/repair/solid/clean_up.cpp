// SPDX-License-Identifier: MIT
#include "repair/solid/clean_up.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "geometry/triangle_meeting.h"
#include "geometry/triangle_tree.h"
#include "measure/self_intersections.h"
#include "mesh/euler_operators.h"

namespace remesher {

namespace {

// Of the cell's width: of each plane that was there, at most. RMS distances of contours from what
// they are of are as large.
constexpr double kTolerance = 0.02;
// Edges that are so short are rounding of the lattice, and may cost more.
constexpr double kShortEdge = 0.2, kToleranceOfShort = 0.06;
// No edge becomes longer, in cells: a look around long ones is a look at all that is near.
constexpr double kLongest = 6;
// No smaller angles are made, and no triangle turns by more than 40°.
const double kSmallestTangent = std::tan(radians(15));
const double kMostTurned = std::cos(radians(40));

// Weighted squared distances from planes [Garland & Heckbert 1997].
struct PlaneSum {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Vec3 vector = Vec3::Zero();
  double constant = 0;

  // Relative to `origin`, for accuracy far from zero.
  void add(const Vec3& normal, const Vec3& at, double weight) {
    const double distance = -normal.dot(at);
    matrix += weight * normal * normal.transpose();
    vector += weight * distance * normal;
    constant += weight * distance * distance;
  }
  void add(const PlaneSum& other) {
    matrix += other.matrix, vector += other.vector, constant += other.constant;
  }
  double at(const Vec3& p) const {
    return std::max(0.0, p.dot(matrix * p) + 2 * vector.dot(p) + constant);
  }
};

// Of the smallest angle, which is opposite the shortest edge: as good to compare, and sooner known.
double tangentOfSmallest(const Triangle& t) {
  const double ab = (t[1] - t[0]).squaredNorm(), bc = (t[2] - t[1]).squaredNorm(),
               ca = (t[0] - t[2]).squaredNorm();
  const double beside = 0.5 * (ab + bc + ca) - std::min({ab, bc, ca});
  return beside > 0 ? areaVector(t[0], t[1], t[2]).norm() / beside : 0;
}

class Cleaner {
 public:
  // Points that are locked stay.
  Cleaner(const Contour& contour, const CleaningRule& rule, std::span<const char> isLocked)
      : contour_(contour),
        rule_(rule),
        mesh_(contour.points.size(), contour.corners),
        sums_(contour.points.size()),
        isLocked_(isLocked),
        isWorthATry_(contour.points.size(), 1) {
    for (Index f = 0; f < mesh_.faceCapacity(); ++f) addPlanes(Face(f));
  }

  // In passes: of each star one point goes in a pass, so that edges grow evenly.
  void run() {
    constexpr int kMostPasses = 40;  // a bound for whatever hardly gets on, not a choice
    for (int pass = 0; pass < kMostPasses && isAnyWorthATry_; ++pass) {
      isAnyWorthATry_ = false;
      isTouched_.assign(mesh_.vertexCapacity(), 0);
      for (Index i = 0; i < mesh_.vertexCapacity(); ++i) tryVertex(Vertex(i));
    }
  }

  Contour take() const {
    Contour result;
    std::vector<Index> numbers(mesh_.vertexCapacity(), kNone);
    for (Index f = 0; f < mesh_.faceCapacity(); ++f) {
      if (!mesh_.isAlive(Face(f))) continue;
      for (const Vertex v : mesh_.vertices(Face(f))) {
        if (numbers[v.index] == kNone) {
          numbers[v.index] = Index(result.points.size());
          result.points.push_back(contour_.points[v.index]);
          result.pointSources.push_back(contour_.pointSources[v.index]);
        }
        result.corners.push_back(numbers[v.index]);
      }
      result.triangleSources.push_back(contour_.triangleSources[f]);
    }
    return result;
  }

 private:
  // Where a vertex may go, for what it costs.
  using Choice = std::pair<double, Vertex>;

  const Vec3& at(Vertex v) const { return contour_.points[v.index]; }
  Vec3 origin() const { return contour_.points.front(); }

  Triangle cornersOf(Face f) const {
    const auto [a, b, c] = mesh_.vertices(f);
    return {at(a), at(b), at(c)};
  }

  bool isBorder(Halfedge h) const {
    return rule_.kinds[HalfedgeMesh::face(h).index] !=
           rule_.kinds[HalfedgeMesh::face(mesh_.twin(h)).index];
  }

  // Of a triangle without much area the normal says little.
  void addPlanes(Face f) {
    const auto [a, b, c] = mesh_.vertices(f);
    const Vec3 vector = areaVector(at(a), at(b), at(c));
    const double twice = vector.norm();
    if (!(twice > 0)) return;
    const Vec3 normal = vector / twice;
    const double weight = std::min(1.0, 2 * twice / (rule_.spacing * rule_.spacing));
    for (const Vertex v : {a, b, c}) sums_[v].add(normal, at(a) - origin(), weight);
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = HalfedgeMesh::halfedge(f, k);
      if (!isBorder(h)) continue;
      const Vec3 along = at(mesh_.tip(h)) - at(mesh_.origin(h));
      const Vec3 across = along.cross(normal).normalized();
      if (!across.allFinite()) continue;
      for (const Vertex v : {mesh_.origin(h), mesh_.tip(h)})
        sums_[v].add(across, at(v) - origin(), 1);
    }
  }

  // Inside of what is of one kind any neighbour will do, on a border between two those along it.
  bool keepsBorders(Halfedge h) const {
    int borders = 0;
    mesh_.forEachOutgoing(mesh_.origin(h), [&](Halfedge out) { borders += isBorder(out); });
    return borders == 0 || (borders == 2 && isBorder(h));
  }

  // None if it would cost too much.
  double costOf(Halfedge h) const {
    const Vertex from = mesh_.origin(h), into = mesh_.tip(h);
    const double length = (at(into) - at(from)).norm();
    const double share = length < kShortEdge * rule_.spacing ? kToleranceOfShort : kTolerance;
    const double most = share * rule_.spacing;
    const double squared = sums_[from].at(at(into) - origin());
    if (squared > most * most || !keepsBorders(h)) return std::numeric_limits<double>::infinity();
    // Of what costs nothing the shortest edges go first, which keeps triangles even.
    constexpr double kByLength = 1e-4;
    return squared + kByLength * length * length;
  }

  std::vector<Choice> choicesOf(Vertex from) const {
    std::vector<Choice> choices;
    mesh_.forEachOutgoing(from, [&](Halfedge h) {
      const double cost = costOf(h);
      if (std::isfinite(cost)) choices.emplace_back(cost, mesh_.tip(h));
    });
    std::sort(choices.begin(), choices.end());
    return choices;
  }

  void tryVertex(Vertex from) {
    if (!mesh_.isAlive(from) || isTouched_[from] || isLocked_[from.index]) return;
    if (!std::exchange(isWorthATry_[from], 0)) return;
    const std::vector<Choice> choices = choicesOf(from);
    if (choices.empty()) return;
    const double least = std::min(kSmallestTangent, smallestAround(from));
    for (const auto& [cost, into] : choices) {
      const Halfedge h = mesh_.find(from, into);
      if (isTooLong(h) || !staysSound(h, least) || !EulerOperators::canCollapse(mesh_, h)) continue;
      collapse(h);
      return;
    }
  }

  bool isTooLong(Halfedge h) const {
    const double most = kLongest * rule_.spacing;
    bool isAny = false;
    mesh_.forEachNeighbor(mesh_.origin(h), [&](Vertex v) {
      isAny = isAny || (at(v) - at(mesh_.tip(h))).squaredNorm() > most * most;
    });
    return isAny;
  }

  static bool turns(const Triangle& before, const Triangle& after) {
    const Vec3 was = areaVector(before[0], before[1], before[2]);
    const Vec3 is = areaVector(after[0], after[1], after[2]);
    return is.dot(was) <= kMostTurned * is.norm() * was.norm() &&
           tangentOfSmallest(before) >= kSmallestTangent;
  }

  // Of the smallest angle of the star; needles may become others as good.
  double smallestAround(Vertex v) const {
    double worst = std::numeric_limits<double>::infinity();
    mesh_.forEachOutgoing(v, [&](Halfedge h) {
      worst = std::min(worst, tangentOfSmallest(cornersOf(HalfedgeMesh::face(h))));
    });
    return worst;
  }

  // Whether what becomes of the star has area, no smaller angles, and faces as it did.
  bool staysSound(Halfedge h, double least) const {
    const Vertex from = mesh_.origin(h), into = mesh_.tip(h);
    bool isSound = true;
    mesh_.forEachOutgoing(from, [&](Halfedge out) {
      if (!isSound || mesh_.tip(out) == into || mesh_.opposite(out) == into) return;
      const Vec3 &b = at(mesh_.tip(out)), &c = at(mesh_.opposite(out));
      const Triangle before = {at(from), b, c}, after = {at(into), b, c};
      isSound = tangentOfSmallest(after) >= least && !turns(before, after) && hasArea(after);
    });
    return isSound;
  }

  void collapse(Halfedge h) {
    const Vertex from = mesh_.origin(h), into = mesh_.tip(h);
    sums_[into].add(sums_[from]);
    EulerOperators(mesh_).collapse(h);
    mesh_.forEachNeighbor(into, [&](Vertex v) { isTouched_[v] = isWorthATry_[v] = 1; });
    isTouched_[into] = isWorthATry_[into] = 1;
    isAnyWorthATry_ = true;
  }

  const Contour& contour_;
  const CleaningRule& rule_;
  HalfedgeMesh mesh_;
  VertexData<PlaneSum> sums_;
  std::span<const char> isLocked_;  // per point
  VertexData<char> isTouched_;      // in this pass
  VertexData<char> isWorthATry_;    // its star has changed since it was tried
  bool isAnyWorthATry_ = true;
};

TriangleMesh meshFrom(const Contour& contour) {
  TriangleMesh mesh;
  mesh.positions = contour.points;
  mesh.indices = contour.corners;
  return mesh;
}

// The points of the contour beside triangles of what became of it.
void lockAround(std::span<const Index> triangles, const TriangleMesh& mesh, const Contour& contour,
                std::vector<char>& isLocked) {
  const TriangleTree tree(mesh.positions, mesh.indices);
  std::vector<char> isMeant(mesh.triangleCount(), 0);
  for (const Index t : triangles) isMeant[t] = 1;
  for (std::size_t v = 0; v < contour.points.size(); ++v) {
    const Vec3& p = contour.points[v];
    tree.visitOverlapping({p, p}, [&](Index t) { isLocked[v] = isLocked[v] || isMeant[t]; });
  }
}

}  // namespace

Contour cleanedUp(const Contour& contour, const CleaningRule& rule) {
  constexpr int kTries = 4;  // each locks more points; after the last the contour stays as it was
  if (contour.corners.empty()) return contour;
  std::vector<char> isLocked(contour.points.size(), 0);
  for (int i = 0; i < kTries; ++i) {
    Cleaner cleaner(contour, rule, isLocked);
    cleaner.run();
    Contour result = cleaner.take();
    const TriangleMesh mesh = meshFrom(result);
    const std::vector<Index> crossed = selfIntersections(mesh);
    if (crossed.empty()) return result;
    lockAround(crossed, mesh, contour, isLocked);
  }
  return contour;
}

}  // namespace remesher
