// SPDX-License-Identifier: MIT
#include "contact/face_overlay.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "arrangement/sheet_triangulation.h"
#include "base/fires.h"
#include "geometry/triangle.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

using Way = std::pair<Index, Index>;  // from one point to another

class Overlay {
 public:
  Overlay(const MetFaces& met, const std::vector<Index>& cluster)
      : soup_(met.soup), flat_(met.flat), cluster_(cluster) {
    for (const Index f : cluster) {
      ways_.emplace_back();
      for (const Index h : flat_.faces[f].border) addWays(h, met.divided);
    }
    number();
    setAxes();
  }

  bool isInPlane(double tolerance) const {
    return std::all_of(points_.begin(), points_.end(), [&](Index p) {
      return std::abs(normal_.dot(soup_.points[p] - origin_)) <= tolerance;
    });
  }

  std::optional<std::vector<OverlaidTriangle>> run() {
    PointPool pool(flattened());
    const std::optional<GivenPlane> plane = planeIn(pool);
    if (!plane) return std::nullopt;
    SheetTriangulation cut(pool, *plane);
    if (!insertAll(pool, cut)) {
      fires("contact: points lie on each other");
      return std::nullopt;
    }
    if (pool.size() > points_.size() + kFarPoints) {
      fires("contact: borders cross beyond the tolerance");
      return std::nullopt;
    }
    cut.widenAngles();
    return filled(cut);
  }

 private:
  static constexpr std::size_t kFarPoints = 4;

  bool isTurned(std::size_t i) const { return flat_.faces[cluster_[i]].normal.dot(normal_) < 0; }

  // Ways with the face to their left, seen along the normal of the first face.
  void addWays(Index h, const DividedEdges& divided) {
    const std::array<Index, 3>& c = soup_.triangles[h / 3].corners;
    const Index a = c[h % 3], b = c[(h + 1) % 3];
    std::vector<Index> line = divided.between(a, b);
    line.insert(line.begin(), a);
    line.push_back(b);
    for (std::size_t i = 1; i < line.size(); ++i) ways_.back().emplace_back(line[i - 1], line[i]);
  }

  void number() {
    for (const std::vector<Way>& ways : ways_)
      for (const auto& [a, b] : ways) points_.insert(points_.end(), {a, b});
    std::sort(points_.begin(), points_.end());
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    for (Index i = 0; i < points_.size(); ++i) numbers_[points_[i]] = i;
  }

  // In the plane of the first face, which is the largest triangle's.
  void setAxes() {
    const FlatFace& face = flat_.faces[cluster_.front()];
    normal_ = face.normal;
    origin_ = face.origin;
    Eigen::Index least = 0;
    normal_.cwiseAbs().minCoeff(&least);
    u_ = normal_.cross(Vec3::Unit(least)).normalized();
    v_ = normal_.cross(u_);
    for (std::size_t i = 0; i < cluster_.size(); ++i)
      if (isTurned(i))
        for (Way& way : ways_[i]) std::swap(way.first, way.second);
  }

  std::vector<Vec3> flattened() const {
    std::vector<Vec3> flat;
    double most = 0;
    for (const Index p : points_) {
      const Vec3 way = soup_.points[p] - origin_;
      flat.emplace_back(u_.dot(way), v_.dot(way), 0);
      most = std::max(most, flat.back().cwiseAbs().maxCoeff());
    }
    for (Vec3& p : flat) p /= 2 * most;
    return flat;
  }

  static std::optional<GivenPlane> planeIn(const PointPool& pool) {
    for (Index c = 2; c < pool.givenCount(); ++c)
      if (pool.turn(0, 1, c, FlatView{}) != 0) return GivenPlane{0, 1, c};
    return std::nullopt;
  }

  // In the order of positions, so that the numbers of points do not matter. False if two are equal.
  bool insertAll(const PointPool& pool, SheetTriangulation& cut) const {
    std::vector<Index> order(points_.size());
    for (Index i = 0; i < order.size(); ++i) order[i] = i;
    const auto isBefore = [&](Index p, Index q) { return pool.isBefore(p, q); };
    std::sort(order.begin(), order.end(), isBefore);
    for (std::size_t i = 1; i < order.size(); ++i)
      if (pool.position(order[i - 1]) == pool.position(order[i])) return false;
    for (const Index p : order) cut.insert(p);
    std::vector<Way> segments;
    for (const std::vector<Way>& ways : ways_)
      for (const auto& [from, to] : ways) {
        const Index a = numbers_.at(from), b = numbers_.at(to);
        segments.push_back(isBefore(a, b) ? Way(a, b) : Way(b, a));
      }
    std::sort(segments.begin(), segments.end(), [&](const Way& s, const Way& t) {
      return s.first != t.first ? isBefore(s.first, t.first) : isBefore(s.second, t.second);
    });
    segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
    for (const auto& [a, b] : segments)
      cut.force({a, b, {{std::min(a, b), std::max(a, b), kNone}}});
    return true;
  }

  // None if a border is no edge of the triangulation, or encloses nothing.
  std::optional<std::vector<OverlaidTriangle>> filled(const SheetTriangulation& cut) const {
    std::map<Way, Index> triangleAt;
    for (Index t = 0; t < cut.triangleCount(); ++t) {
      const std::array<Index, 3> c = cut.triangle(t);
      for (std::size_t k = 0; k < 3; ++k) triangleAt[{c[k], c[(k + 1) % 3]}] = t;
    }
    std::vector<std::vector<std::size_t>> facesOf(cut.triangleCount());
    for (std::size_t i = 0; i < cluster_.size(); ++i)
      if (!fill(cut, triangleAt, i, facesOf)) return std::nullopt;
    std::vector<OverlaidTriangle> result;
    for (Index t = 0; t < cut.triangleCount(); ++t) add(cut.triangle(t), facesOf[t], result);
    return result;
  }

  bool fill(const SheetTriangulation& cut, const std::map<Way, Index>& triangleAt, std::size_t i,
            std::vector<std::vector<std::size_t>>& facesOf) const {
    std::set<Way> border;
    std::vector<Index> found;
    std::vector<char> isFound(cut.triangleCount(), 0);
    const auto take = [&](Index t) {
      if (!isFound[t]) found.push_back(t);
      isFound[t] = 1;
    };
    for (const auto& [from, to] : ways_[i]) {
      const Way way(numbers_.at(from), numbers_.at(to));
      const auto beside = triangleAt.find(way);
      if (beside == triangleAt.end()) return false;
      border.insert(way);
      take(beside->second);
    }
    for (std::size_t n = 0; n < found.size(); ++n) {
      const std::array<Index, 3> c = cut.triangle(found[n]);
      for (Index k = 0; k < 3; ++k) {
        if (c[k] >= points_.size()) return false;
        if (!border.contains({c[k], c[(k + 1) % 3]})) take(cut.neighbor(found[n], k));
      }
    }
    for (const Index t : found) facesOf[t].push_back(i);
    return true;
  }

  Index bodyOf(std::size_t i) const {
    return soup_.triangles[flat_.faces[cluster_[i]].triangles.front()].body;
  }

  // Each face with the first one that it lies on; the rest by themselves.
  void add(const std::array<Index, 3>& corners, std::vector<std::size_t> faces,
           std::vector<OverlaidTriangle>& result) const {
    while (!faces.empty()) {
      const std::size_t own = faces.front();
      faces.erase(faces.begin());
      const auto other = std::find_if(faces.begin(), faces.end(), [&](std::size_t i) {
        return isTurned(i) != isTurned(own) && bodyOf(i) != bodyOf(own);
      });
      // All triangles of two bodies are turned the same way.
      const bool isFirst = other == faces.end() || bodyOf(own) < bodyOf(*other);
      const std::size_t front = isFirst ? own : *other;
      OverlaidTriangle made{{}, cluster_[front]};
      for (std::size_t k = 0; k < 3; ++k) made.corners[k] = points_[corners[k]];
      if (isTurned(front)) std::swap(made.corners[1], made.corners[2]);
      if (other != faces.end()) {
        made.other = cluster_[isFirst ? *other : own];
        faces.erase(other);
      }
      result.push_back(made);
    }
  }

  const BodySoup& soup_;
  const FlatFaces& flat_;
  const std::vector<Index>& cluster_;
  std::vector<std::vector<Way>> ways_;  // per face of the cluster
  std::vector<Index> points_;           // of the borders
  std::map<Index, Index> numbers_;      // of these
  Vec3 normal_ = Vec3::Zero(), origin_ = Vec3::Zero(), u_ = Vec3::Zero(), v_ = Vec3::Zero();
};

}  // namespace

std::optional<std::vector<OverlaidTriangle>> overlaid(const MetFaces& met,
                                                      const std::vector<Index>& cluster,
                                                      double tolerance) {
  Overlay overlay(met, cluster);
  if (!overlay.isInPlane(tolerance)) {
    fires("contact: faces of one cluster in several planes");
    return std::nullopt;
  }
  return overlay.run();
}

}  // namespace remesher
