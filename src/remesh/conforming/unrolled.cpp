// SPDX-License-Identifier: MIT
#include "remesh/conforming/unrolled.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/options.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

// The normals of a region are within this angle of their mean: a region is never a whole ring,
// whose ends could not lie in one plane.
constexpr double kMostTurned = radians(46);
// Lines that bend by more are part of the shape.
constexpr double kSmooth = radians(30);

class Unrolling {
 public:
  Unrolling(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
            const FaceData<Index>& facets, double tolerance)
      : mesh_(mesh), positions_(positions), facets_(facets), tolerance_(tolerance), joined_(0) {
    Index count = 0;
    for (Index i = 0; i < mesh.faceCapacity(); ++i)
      if (mesh.isAlive(Face(i))) count = std::max(count, facets[Face(i)] + 1);
    regions_.resize(count);
    joined_ = DisjointSets(count);
    for (Index i = 0; i < mesh.faceCapacity(); ++i)
      if (mesh.isAlive(Face(i))) measure(Face(i));
    for (Region& region : regions_) lay(region);
  }

  // Regions grow by pairs, those first that bend least together, so that a ring falls into even
  // parts.
  void run(const HalfedgeData<char>& fixed, double depth) {
    std::vector<Line> lines = gather(fixed, depth);
    for (bool hasGrown = true; hasGrown;) {
      hasGrown = false;
      for (Line& line : lines) line.turn = turnOver(line.edge);
      std::erase_if(lines, [](const Line& line) { return !(line.turn <= kMostTurned); });
      std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) {
        return std::pair(-a.slenderness, a.turn) < std::pair(-b.slenderness, b.turn);
      });
      std::vector<char> isGrown(regions_.size(), 0);
      for (const Line& line : lines) {
        const auto [one, other] = regionsAt(line.edge);
        if (one == other || isGrown[one] || isGrown[other] || !join(line.edge)) continue;
        isGrown[one] = isGrown[other] = 1;
        hasGrown = true;
      }
    }
  }

  Unrolled result() {
    Unrolled made;
    made.regionOf.assign(mesh_.faceCapacity(), kNone);
    made.corners.assign(mesh_.faceCapacity(), {});
    std::vector<Index> number(regions_.size(), kNone);
    for (Index i = 0; i < mesh_.faceCapacity(); ++i) {
      const Face f(i);
      if (!mesh_.isAlive(f)) continue;
      const Index region = joined_.find(facets_[f]);
      if (number[region] == kNone) {
        number[region] = Index(made.isBent.size());
        made.isBent.push_back(regions_[region].facets.size() > 1);
      }
      made.regionOf[f] = number[region];
      const auto vertices = mesh_.vertices(f);
      for (std::size_t k = 0; k < 3; ++k)
        made.corners[f][k] = regions_[region].at.at(vertices[k].index);
    }
    return made;
  }

 private:
  struct Region {
    std::vector<Index> facets;
    std::vector<Face> faces;
    std::map<Index, Vec2> at;    // the vertices in the plane
    Vec3 normal = Vec3::Zero();  // the sum of area vectors
    double area = 0, border = 0;
    double width() const { return 2 * area / border; }
  };
  struct Line {
    Halfedge edge;
    double slenderness;
    double turn = 0;  // of both regions together
  };

  void measure(Face f) {
    Region& region = regions_[facets_[f]];
    if (region.facets.empty()) region.facets.push_back(facets_[f]);
    region.faces.push_back(f);
    const auto [a, b, c] = mesh_.vertices(f);
    const Vec3 vector = areaVector(positions_[a], positions_[b], positions_[c]);
    region.normal += vector;
    region.area += vector.norm() / 2;
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = HalfedgeMesh::halfedge(f, k), t = mesh_.twin(h);
      if (!t || facets_[mesh_.face(t)] != facets_[f]) region.border += lengthOf(h);
    }
  }

  double lengthOf(Halfedge h) const {
    return (positions_[mesh_.tip(h)] - positions_[mesh_.origin(h)]).norm();
  }

  void lay(Region& region) {
    if (region.faces.empty()) return;
    const Vec3 normal = region.normal.stableNormalized(), u = normal.unitOrthogonal();
    const Vec3 v = normal.cross(u), origin = positions_[mesh_.vertices(region.faces[0])[0]];
    for (const Face f : region.faces)
      for (const Vertex corner : mesh_.vertices(f)) {
        const Vec3 p = positions_[corner] - origin;
        region.at[corner.index] = {u.dot(p), v.dot(p)};
      }
  }

  Vec3 normalOf(Index facet) const { return normals_[facet]; }

  // The lines across which regions may grow; others part them for good.
  std::vector<Line> gather(const HalfedgeData<char>& fixed, double depth) {
    for (const Region& region : regions_) normals_.push_back(region.normal.stableNormalized());
    parted_.resize(regions_.size());
    std::map<std::pair<Index, Index>, Line> lines;
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
      const Halfedge h(i), t = mesh_.isEdge(h) ? mesh_.twin(h) : Halfedge();
      if (!t) continue;
      const auto [one, other] = std::minmax(facets_[mesh_.face(h)], facets_[mesh_.face(t)]);
      if (one == other) continue;
      const double turn = std::acos(std::clamp(normalOf(one).dot(normalOf(other)), -1.0, 1.0));
      if (fixed[h] || fixed[t] || !(turn < kSmooth)) {
        parted_[one].push_back(other);
        parted_[other].push_back(one);
        continue;
      }
      const double width = std::max(regions_[one].width(), regions_[other].width());
      if (!(width * std::sin(turn / 2) <= depth)) continue;
      const Line line{h, std::round(std::log2(lengthOf(h) / width))};
      const auto [at, isNew] = lines.try_emplace({one, other}, line);
      if (!isNew && line.slenderness > at->second.slenderness) at->second = line;
    }
    std::vector<Line> result;
    for (const auto& [pair, line] : lines) result.push_back(line);
    return result;
  }

  bool areParted(const Region& region, Index other) {
    return std::any_of(region.facets.begin(), region.facets.end(), [&](Index facet) {
      return std::any_of(parted_[facet].begin(), parted_[facet].end(),
                         [&](Index beyond) { return joined_.find(beyond) == other; });
    });
  }

  std::pair<Index, Index> regionsAt(Halfedge h) {
    return {joined_.find(facets_[mesh_.face(h)]), joined_.find(facets_[mesh_.face(mesh_.twin(h))])};
  }

  // The largest angle between a normal of the regions beside a line and their mean.
  double turnOver(Halfedge h) {
    const auto [one, other] = regionsAt(h);
    const Vec3 mean = (regions_[one].normal + regions_[other].normal).stableNormalized();
    double least = 1;
    for (const Index region : {one, other})
      for (const Index facet : regions_[region].facets)
        least = std::min(least, normalOf(facet).dot(mean));
    return one == other ? kInfinity : std::acos(std::max(least, -1.0));
  }

  // Lays the smaller of two regions beside the larger one, if all of its vertices that both have
  // come to lie on each other.
  bool join(Halfedge h) {
    auto [small, large] = regionsAt(h);
    if (regions_[small].at.size() > regions_[large].at.size()) std::swap(small, large);
    Region &from = regions_[small], &into = regions_[large];
    if (areParted(from, large)) return false;
    const Index a = mesh_.origin(h).index, b = mesh_.tip(h).index;
    const Vec2 before = from.at.at(b) - from.at.at(a), after = into.at.at(b) - into.at.at(a);
    const Vec2 first = from.at.at(a), place = into.at.at(a);
    const double scale = before.norm() * after.norm();
    if (!(scale > 0)) return false;
    const double cosine = before.dot(after) / scale, sine = cross(before, after) / scale;
    const auto laid = [&](const Vec2& p) {
      const Vec2 q = p - first;
      return Vec2(place + Vec2(cosine * q.x() - sine * q.y(), sine * q.x() + cosine * q.y()));
    };
    for (const auto& [v, p] : from.at) {
      const auto found = into.at.find(v);
      if (found != into.at.end() && (laid(p) - found->second).norm() > tolerance_) return false;
    }
    for (const auto& [v, p] : from.at) into.at.try_emplace(v, laid(p));
    into.facets.insert(into.facets.end(), from.facets.begin(), from.facets.end());
    into.normal += from.normal;
    from = {};
    joined_.unite(small, large);
    if (joined_.find(small) == small) std::swap(from, into);
    return true;
  }

  const HalfedgeMesh& mesh_;
  const VertexData<Vec3>& positions_;
  const FaceData<Index>& facets_;
  double tolerance_;
  std::vector<Region> regions_;             // those of facets, some of them joined to others
  std::vector<Vec3> normals_;               // of facets
  std::vector<std::vector<Index>> parted_;  // facets beyond lines that stay
  DisjointSets joined_;
};

}  // namespace

Unrolled unrollFacets(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                      const FaceData<Index>& facets, const HalfedgeData<char>& fixed, double depth,
                      double tolerance) {
  Unrolling unrolling(mesh, positions, facets, tolerance);
  if (depth > 0) unrolling.run(fixed, depth);
  return unrolling.result();
}

}  // namespace remesher
