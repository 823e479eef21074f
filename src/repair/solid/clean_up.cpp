// SPDX-License-Identifier: MIT
#include "repair/solid/clean_up.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/fires.h"
#include "geometry/quadric.h"
#include "geometry/triangle_meeting.h"
#include "geometry/triangle_tree.h"
#include "measure/self_intersections.h"
#include "mesh/euler_operators.h"
#include "mesh/star_passes.h"

namespace remesher {

namespace {

// The greatest root of a weighted sum of squared distances from original planes, in cell widths.
// The RMS distance of a contour from its surface is as large.
constexpr double kTolerance = 0.02;
// Edges this short (in cell widths) are rounding of the lattice, and may cost more.
constexpr double kShortEdge = 0.2, kToleranceOfShort = 0.06;
// No edge becomes longer, in cells: a search around a long edge visits all that is near.
constexpr double kLongest = 6;
// A collapse makes a smaller angle only if its star has one as small. It turns no triangle by more
// than 40°, unless that had a smaller angle: normals of needles mean little.
const double kSmallestTangent = std::tan(radians(15));
const double kMostTurned = std::cos(radians(40));

// The tangent of the smallest angle, which is opposite the shortest edge. It compares like the
// angle, and is faster to compute.
double tangentOfSmallest(const Triangle& t) {
  const double ab = (t[1] - t[0]).squaredNorm(), bc = (t[2] - t[1]).squaredNorm(),
               ca = (t[0] - t[2]).squaredNorm();
  const double beside = 0.5 * (ab + bc + ca) - std::min({ab, bc, ca});
  return beside > 0 ? areaVector(t[0], t[1], t[2]).norm() / beside : 0;
}

// A point that was collapsed into a neighbour.
struct Merger {
  Vertex from, into;
};

class Cleaner {
 public:
  Cleaner(const Contour& contour, const CleaningRule& rule)
      : contour_(contour),
        rule_(rule),
        mesh_(contour.points.size(), contour.corners),
        hasBorders_(std::adjacent_find(rule.kinds.begin(), rule.kinds.end(),
                                       std::not_equal_to<>()) != rule.kinds.end()),
        sums_(contour.points.size()),
        isOther_(contour.points.size(), 0) {
    for (Index f = 0; f < mesh_.faceCapacity(); ++f) addPlanes(Face(f));
  }

  std::vector<Merger> run() {
    isWorthATry_.assign(mesh_.vertexCapacity(), 1);
    std::vector<Merger> mergers;
    StarPasses passes(mesh_);
    const auto merge = [&](Vertex from) {
      const Vertex into = tryVertex(from);
      if (into) mergers.push_back({from, into});
      return into;
    };
    while (passes.run(merge) > 0) {
    }
    return mergers;
  }

  // Repeats the mergers of another run, except those of locked points. Where a star differs from
  // that run, a merger is done only if it is allowed now. Returns the mergers done.
  std::vector<Merger> repeat(std::span<const Merger> mergers, std::span<const char> isLocked) {
    std::vector<Merger> done;
    for (Index i = 0; i < isLocked.size(); ++i) isOther_[Vertex(i)] = isLocked[i];
    for (const Merger& merger : mergers) {
      if (isLocked[merger.from.index] || !(isAsThen(merger) || isAllowed(merger))) {
        markOther(merger);
        continue;
      }
      collapse(mesh_.find(merger.from, merger.into));
      done.push_back(merger);
    }
    return done;
  }

  struct Result {
    Contour contour;
    Index firstOther = 0;  // triangles from here on have a corner marked other
  };

  Result take() const {
    Result result;
    std::vector<Index> numbers(mesh_.vertexCapacity(), kNone);
    add(result.contour, numbers, 0);
    result.firstOther = Index(result.contour.triangleSources.size());
    add(result.contour, numbers, 1);
    return result;
  }

 private:
  // The cost of a collapse, and the collapse.
  using Choice = std::pair<double, Halfedge>;

  const Vec3& at(Vertex v) const { return contour_.points[v.index]; }
  // Of the quadrics, for accuracy far from zero.
  Vec3 origin() const { return contour_.points.front(); }

  Triangle cornersOf(Face f) const {
    const auto [a, b, c] = mesh_.vertices(f);
    return {at(a), at(b), at(c)};
  }

  bool isBorder(Halfedge h) const {
    return hasBorders_ && rule_.kinds[HalfedgeMesh::face(h).index] !=
                              rule_.kinds[HalfedgeMesh::face(mesh_.twin(h)).index];
  }

  // Small triangles weigh less, for their normals are unreliable.
  void addPlanes(Face f) {
    const auto [a, b, c] = mesh_.vertices(f);
    const Vec3 vector = areaVector(at(a), at(b), at(c));
    const double twice = vector.norm();
    if (!(twice > 0)) return;
    const Vec3 normal = vector / twice;
    const double weight = std::min(1.0, 2 * twice / (rule_.spacing * rule_.spacing));
    for (const Vertex v : {a, b, c}) sums_[v].addPlane(normal, at(a) - origin(), weight);
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = HalfedgeMesh::halfedge(f, k);
      if (!isBorder(h)) continue;
      const Vec3 along = at(mesh_.tip(h)) - at(mesh_.origin(h));
      const Vec3 across = along.cross(normal).normalized();
      if (!across.allFinite()) continue;
      for (const Vertex v : {mesh_.origin(h), mesh_.tip(h)})
        sums_[v].addPlane(across, at(v) - origin(), 1);
    }
  }

  int bordersAt(Vertex v) const {
    int borders = 0;
    if (!hasBorders_) return borders;
    mesh_.forEachOutgoing(v, [&](Halfedge h) { borders += isBorder(h); });
    return borders;
  }

  // Inside one kind any neighbour is allowed; on a border between two kinds, neighbours along it.
  bool keepsBorders(Halfedge h, int borders) const {
    return borders == 0 || (borders == 2 && isBorder(h));
  }

  // Infinite above the tolerance.
  double costOf(Halfedge h) const {
    const Vertex from = mesh_.origin(h), into = mesh_.tip(h);
    const double length = (at(into) - at(from)).squaredNorm();  // squared
    const double shortest = kShortEdge * rule_.spacing;
    const double most =
        rule_.spacing * (length < shortest * shortest ? kToleranceOfShort : kTolerance);
    const double squared = std::max(0.0, sums_[from].at(at(into) - origin()));
    if (squared > most * most) return kInfinity;
    // Among collapses without cost the shortest edges go first, which keeps triangles even.
    constexpr double kByLength = 1e-4;
    return squared + kByLength * length;
  }

  void findChoices(Vertex from) {
    choices_.clear();
    const int borders = bordersAt(from);
    if (borders != 0 && borders != 2) return;
    mesh_.forEachOutgoing(from, [&](Halfedge h) {
      const double cost = keepsBorders(h, borders) ? costOf(h) : 0;
      if (cost > 0 && std::isfinite(cost)) choices_.emplace_back(cost, h);
    });
    std::sort(choices_.begin(), choices_.end(), [&](const Choice& a, const Choice& b) {
      return a.first != b.first ? a.first < b.first : mesh_.tip(a.second) < mesh_.tip(b.second);
    });
  }

  // The neighbour that the vertex was collapsed into, or none.
  Vertex tryVertex(Vertex from) {
    if (!std::exchange(isWorthATry_[from], 0)) return {};
    findChoices(from);
    for (const auto& [cost, h] : choices_) {
      const Vertex into = mesh_.tip(h);
      if (isTooLong(h) || !staysSound(h) || !EulerOperators::canCollapse(mesh_, h)) continue;
      collapse(h);
      mesh_.forEachNeighbor(into, [&](Vertex v) { isWorthATry_[v] = 1; });
      isWorthATry_[into] = 1;
      return into;
    }
    return {};
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

  // The tangent of the smallest angle in the star.
  double smallestAround(Vertex v) const {
    double worst = kInfinity;
    mesh_.forEachOutgoing(v, [&](Halfedge h) {
      worst = std::min(worst, tangentOfSmallest(cornersOf(HalfedgeMesh::face(h))));
    });
    return worst;
  }

  // A narrower triangle may be made if the star has one as narrow.
  bool isWideEnough(const Triangle& after, Vertex from) const {
    const double tangent = tangentOfSmallest(after);
    return tangent >= kSmallestTangent || (tangent >= smallestAround(from) && hasArea(after));
  }

  // Whether the changed star has area, no smaller angles than before, and faces as before.
  bool staysSound(Halfedge h) const {
    const Vertex from = mesh_.origin(h), into = mesh_.tip(h);
    bool isSound = true;
    mesh_.forEachOutgoing(from, [&](Halfedge out) {
      if (!isSound || mesh_.tip(out) == into || mesh_.opposite(out) == into) return;
      const Vec3 &b = at(mesh_.tip(out)), &c = at(mesh_.opposite(out));
      const Triangle before = {at(from), b, c}, after = {at(into), b, c};
      isSound = !turns(before, after) && isWideEnough(after, from);
    });
    return isSound;
  }

  void collapse(Halfedge h) {
    sums_[mesh_.tip(h)].add(sums_[mesh_.origin(h)]);
    EulerOperators(mesh_).collapse(h);
  }

  bool isAsThen(const Merger& merger) const {
    bool isAny = isOther_[merger.from] || isOther_[merger.into];
    mesh_.forEachNeighbor(merger.from, [&](Vertex v) { isAny = isAny || isOther_[v]; });
    return !isAny;
  }

  bool isAllowed(const Merger& merger) const {
    const Halfedge h = mesh_.find(merger.from, merger.into);
    return h && keepsBorders(h, bordersAt(merger.from)) && std::isfinite(costOf(h)) &&
           !isTooLong(h) && staysSound(h) && EulerOperators::canCollapse(mesh_, h);
  }

  // Marks the stars around a merger that only the other run did.
  void markOther(const Merger& merger) {
    isOther_[merger.from] = isOther_[merger.into] = 1;
    mesh_.forEachNeighbor(merger.from, [&](Vertex v) { isOther_[v] = 1; });
  }

  // Adds the triangles with a corner marked other (wanted = 1), or those without (wanted = 0).
  void add(Contour& result, std::vector<Index>& numbers, char wanted) const {
    for (Index f = 0; f < mesh_.faceCapacity(); ++f) {
      if (!mesh_.isAlive(Face(f))) continue;
      const std::array<Vertex, 3> corners = mesh_.vertices(Face(f));
      const bool isOther = isOther_[corners[0]] || isOther_[corners[1]] || isOther_[corners[2]];
      if (char(isOther) != wanted) continue;
      for (const Vertex v : corners) {
        if (numbers[v.index] == kNone) {
          numbers[v.index] = Index(result.points.size());
          result.points.push_back(contour_.points[v.index]);
          result.pointSources.push_back(contour_.pointSources[v.index]);
        }
        result.corners.push_back(numbers[v.index]);
      }
      result.triangleSources.push_back(contour_.triangleSources[f]);
    }
  }

  const Contour& contour_;
  const CleaningRule& rule_;
  HalfedgeMesh mesh_;
  const bool hasBorders_;  // between kinds
  VertexData<Quadric> sums_;
  VertexData<char> isOther_;      // locked, or its star differs from the other run
  VertexData<char> isWorthATry_;  // its star has changed since it was tried
  std::vector<Choice> choices_;   // of the vertex that is tried
};

TriangleMesh meshFrom(const Contour& contour) {
  TriangleMesh mesh;
  mesh.positions = contour.points;
  mesh.indices = contour.corners;
  return mesh;
}

std::vector<Index> cornersOf(std::span<const Index> triangles, const TriangleMesh& mesh) {
  std::vector<Index> corners;
  for (const Index t : triangles)
    for (std::size_t k = 0; k < 3; ++k) corners.push_back(mesh.indices[3 * std::size_t{t} + k]);
  return corners;
}

// The points of the contour in the boxes around triangles, with a margin.
void lockAround(const TriangleTree& triangles, double margin, const Contour& contour,
                std::vector<char>& isLocked) {
  const Vec3 around = Vec3::Constant(margin);
  for (std::size_t v = 0; v < contour.points.size(); ++v) {
    const Vec3& p = contour.points[v];
    triangles.visitOverlapping({p - around, p + around}, [&](Index) { isLocked[v] = 1; });
  }
}

}  // namespace

Contour cleanedUp(const Contour& contour, const CleaningRule& rule) {
  constexpr int kTries = 6;  // each locks more points; after the last the contour stays as it was
  if (contour.corners.empty()) return contour;
  std::optional<Cleaner> cleaner(std::in_place, contour, rule);
  std::vector<Merger> mergers = cleaner->run();
  Cleaner::Result result = cleaner->take();
  TriangleMesh mesh = meshFrom(result.contour);
  std::vector<Index> crossed = selfIntersections(mesh);
  std::vector<char> isLocked(contour.points.size(), 0);
  for (int i = 0; i < kTries && !crossed.empty(); ++i) {
    fires("lattice: cleaned again around crossings");
    const std::vector<Index> corners = cornersOf(crossed, mesh);
    lockAround(TriangleTree(mesh.positions, corners), (i + 0.5) * rule.spacing, contour, isLocked);
    cleaner.emplace(contour, rule);
    mergers = cleaner->repeat(mergers, isLocked);
    result = cleaner->take();
    mesh = meshFrom(result.contour);
    crossed = selfIntersectionsFrom(mesh, result.firstOther);
  }
  if (!crossed.empty()) fires("lattice: contour not cleaned");
  return crossed.empty() ? std::move(result.contour) : contour;
}

}  // namespace remesher
