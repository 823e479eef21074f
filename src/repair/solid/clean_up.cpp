// SPDX-License-Identifier: MIT
#include "repair/solid/clean_up.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/triangle_grid.h"
#include "geometry/triangle_meeting.h"
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
constexpr double kSmallestAngle = radians(15);
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

class Cleaner {
 public:
  Cleaner(const Contour& contour, const CleaningRule& rule)
      : contour_(contour),
        rule_(rule),
        mesh_(contour.points.size(), contour.corners),
        sums_(contour.points.size()),
        isWorthATry_(contour.points.size(), 1),
        grid_(2 * rule.spacing, contour.corners.size() / 3) {
    for (Index f = 0; f < mesh_.faceCapacity(); ++f) {
      addPlanes(Face(f));
      grid_.add(f, boxOf(named(Face(f))));
    }
  }

  // In passes: of each star one point goes in a pass, so that edges grow evenly.
  void run() {
    constexpr int kPasses =
        40;  // far more than there are, unless nothing but a little goes in each
    for (int pass = 0; pass < kPasses && isAnyWorthATry_; ++pass) {
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

  NamedTriangle named(Face f) const {
    const auto [a, b, c] = mesh_.vertices(f);
    return {{a.index, b.index, c.index}, {at(a), at(b), at(c)}};
  }

  static Box boxOf(const NamedTriangle& t) {
    Box box;
    for (const Vec3& p : t.at) box.extend(p);
    return box;
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
    if (!mesh_.isAlive(from) || isTouched_[from] || !std::exchange(isWorthATry_[from], 0)) return;
    for (const auto& [cost, into] : choicesOf(from)) {
      const Halfedge h = mesh_.find(from, into);
      if (!mayCollapse(h)) continue;
      collapse(h);
      return;
    }
  }

  static double smallestAngle(const Triangle& t) { return minAngle(t[0], t[1], t[2]); }

  NamedTriangle moved(NamedTriangle t, Vertex from, Vertex into) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (t.vertices[k] == from.index) t.vertices[k] = into.index, t.at[k] = at(into);
    return t;
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
    const Vec3 was = unitNormal(before[0], before[1], before[2]);
    return unitNormal(after[0], after[1], after[2]).dot(was) <= kMostTurned &&
           smallestAngle(before) >= kSmallestAngle;
  }

  // The smallest angle of the star; needles may become others as good.
  double smallestAround(Vertex v) const {
    double worst = std::numeric_limits<double>::infinity();
    mesh_.forEachOutgoing(v, [&](Halfedge h) {
      worst = std::min(worst, smallestAngle(named(HalfedgeMesh::face(h)).at));
    });
    return worst;
  }

  // What the star becomes, if that is sound.
  std::optional<std::vector<NamedTriangle>> comingOf(Halfedge h) const {
    const Vertex from = mesh_.origin(h), into = mesh_.tip(h);
    if (isTooLong(h)) return std::nullopt;
    const double least = std::min(kSmallestAngle, smallestAround(from));
    std::vector<NamedTriangle> coming;
    bool isSound = true;
    mesh_.forEachOutgoing(from, [&](Halfedge out) {
      if (!isSound || mesh_.tip(out) == into || mesh_.opposite(out) == into) return;
      const NamedTriangle before = named(HalfedgeMesh::face(out));
      coming.push_back(moved(before, from, into));
      const Triangle& after = coming.back().at;
      isSound = smallestAngle(after) >= least && !turns(before.at, after) && hasArea(after);
    });
    if (!isSound) return std::nullopt;
    return coming;
  }

  bool meetsAny(Halfedge h, const std::vector<NamedTriangle>& coming) const {
    const Vertex from = mesh_.origin(h);
    bool found = false;
    for (const NamedTriangle& t : coming) {
      const Box box = boxOf(t);
      grid_.visit(box, [&](Index f) {
        if (found || !mesh_.isAlive(Face(f))) return;
        const NamedTriangle other = named(Face(f));
        const auto& v = other.vertices;
        if (std::find(v.begin(), v.end(), from.index) != v.end()) return;
        found = boxOf(other).overlaps(box) && hasArea(other.at) && trianglesMeet(t, other);
      });
    }
    for (std::size_t i = 0; i < coming.size() && !found; ++i)
      for (std::size_t k = 0; k < i; ++k) found = found || trianglesMeet(coming[i], coming[k]);
    return found;
  }

  bool mayCollapse(Halfedge h) const {
    if (!EulerOperators::canCollapse(mesh_, h)) return false;
    const std::optional<std::vector<NamedTriangle>> coming = comingOf(h);
    return coming && !meetsAny(h, *coming);
  }

  void collapse(Halfedge h) {
    const Vertex from = mesh_.origin(h), into = mesh_.tip(h);
    sums_[into].add(sums_[from]);
    mesh_.forEachOutgoing(from, [&](Halfedge out) {
      const Face f = HalfedgeMesh::face(out);
      grid_.remove(f.index, boxOf(named(f)));
    });
    EulerOperators(mesh_).collapse(h);
    std::vector<Vertex> around;
    mesh_.forEachOutgoing(into, [&](Halfedge out) {
      const Face f = HalfedgeMesh::face(out);
      grid_.add(f.index, boxOf(named(f)));
      around.push_back(mesh_.tip(out));
    });
    around.push_back(into);
    for (const Vertex v : around) isTouched_[v] = isWorthATry_[v] = 1;
    isAnyWorthATry_ = true;
  }

  const Contour& contour_;
  const CleaningRule& rule_;
  HalfedgeMesh mesh_;
  VertexData<PlaneSum> sums_;
  VertexData<char> isTouched_;    // in this pass
  VertexData<char> isWorthATry_;  // its star has changed since it was tried
  bool isAnyWorthATry_ = true;
  TriangleGrid grid_;
};

}  // namespace

Contour cleanedUp(const Contour& contour, const CleaningRule& rule) {
  if (contour.corners.empty()) return contour;
  Cleaner cleaner(contour, rule);
  cleaner.run();
  return cleaner.take();
}

}  // namespace remesher
