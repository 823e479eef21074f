// SPDX-License-Identifier: MIT
#include "textures/painting/tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/disjoint_sets.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

// The direction of a triangle's texture.
struct Gradient {
  Vec3 u = Vec3::Zero();  // where u grows, unit or zero
  bool isMirrored = false;
};

Vec3 unit(const Vec3& v) {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : Vec3(Vec3::Zero());
}

Vec3 inPlane(const Vec3& v, const Vec3& normal) { return unit(v - normal.dot(v) * normal); }

Vec3 anyAcross(const Vec3& normal) {
  Eigen::Index smallest = 0;
  normal.cwiseAbs().minCoeff(&smallest);
  return inPlane(Vec3::Unit(smallest), normal);
}

class Tangents {
 public:
  explicit Tangents(const TangentCorners& corners)
      : corners_(corners), shared_(corners.positions.size()) {}

  std::vector<Eigen::Vector4d> run() {
    const std::size_t count = corners_.positions.size();
    for (Index t = 0; 3 * t < count; ++t) gradients_.push_back(gradientOf(t));
    group();
    std::vector<Vec3> sums(count, Vec3::Zero());
    for (Index h = 0; h < count; ++h) sums[shared_.find(h)] += weighted(h);
    std::vector<Eigen::Vector4d> result;
    for (Index h = 0; h < count; ++h) {
      const Vec3& normal = corners_.normals[h];
      Vec3 tangent = inPlane(sums[shared_.find(h)], normal);
      if (tangent.isZero()) tangent = anyAcross(normal);
      result.emplace_back(tangent.x(), tangent.y(), tangent.z(),
                          gradients_[h / 3].isMirrored ? 1.0 : -1.0);
    }
    return result;
  }

 private:
  Gradient gradientOf(Index t) const {
    const Vec2 &a = corners_.texcoords[3 * t], &b = corners_.texcoords[3 * t + 1],
               &c = corners_.texcoords[3 * t + 2];
    const Vec2 s = b - a, q = c - a;
    const double twiceArea = s.x() * q.y() - s.y() * q.x();
    if (twiceArea == 0) return {};
    const Vec3& p = corners_.positions[3 * t];
    const Vec3 u =
        q.y() * (corners_.positions[3 * t + 1] - p) - s.y() * (corners_.positions[3 * t + 2] - p);
    return {unit(twiceArea > 0 ? u : Vec3(-u)), twiceArea < 0};
  }

  // The u direction of a corner's triangle, projected to the plane of the corner's normal, times
  // the corner's angle.
  Vec3 weighted(Index h) const {
    const Vec3& normal = corners_.normals[h];
    const Vec3& p = corners_.positions[h];
    const Vec3 a = inPlane(corners_.positions[nextCorner(h)] - p, normal);
    const Vec3 b = inPlane(corners_.positions[prevCorner(h)] - p, normal);
    return std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * inPlane(gradients_[h / 3].u, normal);
  }

  std::array<double, 8> key(Index h) const {
    const Vec3 &p = corners_.positions[h], &n = corners_.normals[h];
    const Vec2& t = corners_.texcoords[h];
    return {p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), t.x(), t.y()};
  }

  // Equal corners get one number. Corners of neighbours form one group if both ends of their edge
  // are equal.
  void group() {
    const Index count = Index(corners_.positions.size());
    std::vector<Index> order(count), number(count);
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      const auto x = key(a), y = key(b);
      return x != y ? x < y : a < b;
    });
    for (Index i = 0; i < count; ++i)
      number[order[i]] =
          i > 0 && key(order[i]) == key(order[i - 1]) ? number[order[i - 1]] : order[i];
    const EdgeGroups edges(count, number);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges[e].size() != 2) continue;
      const Index a = edges[e][0], b = edges[e][1];
      const bool isAlike = gradients_[a / 3].isMirrored == gradients_[b / 3].isMirrored;
      if (number[a] == number[b] || !isAlike) continue;
      shared_.unite(a, nextCorner(b));
      shared_.unite(nextCorner(a), b);
    }
  }

  const TangentCorners& corners_;
  std::vector<Gradient> gradients_;
  DisjointSets shared_;  // corners
};

}  // namespace

std::vector<Eigen::Vector4d> computeTangents(const TangentCorners& corners) {
  return Tangents(corners).run();
}

}  // namespace remesher
