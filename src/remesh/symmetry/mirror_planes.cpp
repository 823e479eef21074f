// SPDX-License-Identifier: MIT
#include "remesh/symmetry/mirror_planes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "geometry/distance_sampler.h"
#include "geometry/mesh_triangle.h"
#include "geometry/triangle_tree.h"
#include "mesh/welding.h"

namespace remesher {

namespace {

// The center of the surface's area, and the squares around it.
struct Moments {
  Vec3 center = Vec3::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
};
Moments momentsOf(const TriangleMesh& mesh) {
  Moments moments;
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto [a, b, c] = cornersOf(mesh, t);
    const double weight = area(a, b, c);
    sum += weight;
    moments.center += weight / 3 * (a + b + c);
  }
  if (!(sum > 0)) return moments;
  moments.center /= sum;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    Triangle corners = cornersOf(mesh, t);
    Vec3 all = Vec3::Zero();
    for (Vec3& p : corners) {
      p -= moments.center;
      all += p;
    }
    const double weight = area(corners[0], corners[1], corners[2]);
    moments.squares += weight * all * all.transpose();
    for (const Vec3& p : corners) moments.squares += weight * p * p.transpose();
  }
  return moments;
}

// Faces of four corners come as two triangles each, and files do not cut mirrored faces along
// mirrored diagonals: where the corners are mirrored, these are the same surface to those who made
// it.
class Diagonals {
 public:
  explicit Diagonals(const TriangleMesh& mesh) : first_(Welding(mesh).first) {
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      const std::size_t t = i / 3 * 3;
      const Index a = first_[mesh.indices[i]], b = first_[mesh.indices[t + (i + 1) % 3]];
      across_[std::minmax(a, b)].push_back(first_[mesh.indices[t + (i + 2) % 3]]);
    }
  }

  Index first(Index v) const { return first_[v]; }

  // Whether the triangle and a neighbour have a mirror image that is cut along the other diagonal.
  // image(v): the vertex at the mirrored place of v, or kNone.
  template <class ImageOf>
  bool areTurned(const std::array<Index, 3>& triangle, ImageOf imageOf) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = triangle[k], b = triangle[(k + 1) % 3], own = triangle[(k + 2) % 3];
      const std::vector<Index>& beside = across_.at(std::minmax(a, b));
      if (beside.size() != 2) continue;
      const Index other = beside[0] == own ? beside[1] : beside[0];
      const auto cut = across_.find(std::minmax(imageOf(own), imageOf(other)));
      if (cut == across_.end()) continue;
      const auto has = [&](Index v) {
        return std::find(cut->second.begin(), cut->second.end(), v) != cut->second.end();
      };
      if (has(imageOf(a)) && has(imageOf(b))) return true;
    }
    return false;
  }

 private:
  std::vector<Index> first_;  // per vertex the first one at its place
  // Per edge the corners opposite to it.
  std::map<std::pair<Index, Index>, std::vector<Index>> across_;
};

class PlaneSearch {
 public:
  PlaneSearch(const TriangleMesh& mesh, double tolerance)
      : mesh_(mesh), tolerance_(tolerance), moments_(momentsOf(mesh)) {}

  std::vector<MirrorPlane> run(const std::vector<MirrorPlane>& first) {
    for (const MirrorPlane& plane : first)
      if (isAtRightAngles(plane.normal) && isMirror(plane)) planes_.push_back(plane);
    for (Eigen::Index axis = 0; axis < 3; ++axis) tryAxis(Vec3::Unit(axis));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments_.squares);
    for (Eigen::Index i = 0; i < 3; ++i) tryAxis(solver.eigenvectors().col(i));
    for (std::size_t i = first.empty() ? 1 : planes_.size(); i < planes_.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) turnToVertices(planes_[k], planes_[i]);
    return std::move(planes_);
  }

 private:
  // Through vertices of a polygon around the planes' line, rather than through the middles of its
  // sides: quads have vertices on planes, and would cut the polygon's corners off. Not of a square,
  // whose corners are corners of quads, not on a line of them.
  void turnToVertices(MirrorPlane& one, MirrorPlane& other) {
    const Eigen::Vector2d way = towardsVertex(one, other);
    const Vec3 middle = one.offset * one.normal + other.offset * other.normal;
    const auto turned = [&](const Vec3& x, const Vec3& y) {
      const Vec3 normal = way.x() * x + way.y() * y;
      return MirrorPlane{normal, normal.dot(middle)};
    };
    const MirrorPlane first = turned(one.normal, other.normal),
                      second = turned(other.normal, -one.normal);
    constexpr double kOctagon = 0.5;  // above the tangent of 22.5°
    if (way.y() == 0 || way.y() > kOctagon * way.x()) return;
    if (!isMirror(first) || !isMirror(second)) return;
    one = first;
    other = second;
  }

  // From the line of two planes towards the next of the vertices that are farthest from it, along
  // their normals; the planes lie at right angles, so that all four quarters are one. (1, 0) if
  // such a vertex lies on a plane.
  Eigen::Vector2d towardsVertex(const MirrorPlane& one, const MirrorPlane& other) const {
    constexpr double kNear = 1e-6;
    std::vector<Eigen::Vector2d> ways;
    double farthest = 0;
    for (const Index v : mesh_.indices) {
      const double x = one.distance(mesh_.positions[v]), y = other.distance(mesh_.positions[v]);
      ways.emplace_back((x < 0) == (y < 0) ? Eigen::Vector2d(std::abs(x), std::abs(y))
                                           : Eigen::Vector2d(std::abs(y), std::abs(x)));
      farthest = std::max(farthest, ways.back().norm());
    }
    Eigen::Vector2d least(0, 1);
    for (const Eigen::Vector2d& way : ways) {
      if (way.norm() < (1 - kNear) * farthest) continue;
      if (way.minCoeff() <= kNear * farthest) return {1, 0};
      if (way.y() * least.x() < least.y() * way.x()) least = way.normalized();
    }
    return least;
  }

  // To all planes that were found.
  bool isAtRightAngles(const Vec3& normal) const {
    return std::all_of(planes_.begin(), planes_.end(), [&](const MirrorPlane& plane) {
      return std::abs(plane.normal.dot(normal)) <= kSingleRoundOff;
    });
  }

  void tryAxis(Vec3 normal) {
    if (!isAtRightAngles(normal)) return;
    Eigen::Index largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    if (normal[largest] < 0) normal = -normal;
    if ((normal - Vec3::Unit(largest)).norm() < kSingleRoundOff) normal = Vec3::Unit(largest);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Index v : mesh_.indices) {
      low = std::min(low, normal.dot(mesh_.positions[v]));
      high = std::max(high, normal.dot(mesh_.positions[v]));
    }
    const double middle = (low + high) / 2;
    // The center of the area moves a little with the diagonals of bent faces.
    constexpr double kOfWidth = 0.05;
    const double off = std::abs(middle - normal.dot(moments_.center));
    if (off > std::max(tolerance_, kOfWidth * (high - low))) return;
    // A model that was made has its plane through the origin, exactly.
    const MirrorPlane plane{normal, std::abs(middle) < kSingleRoundOff * (high - low) ? 0 : middle};
    if (isMirror(plane)) planes_.push_back(plane);
  }

  bool isMirror(const MirrorPlane& plane) {
    if (!tree_) tree_.emplace(mesh_.positions, mesh_.indices);
    // Most planes that do not mirror the surface fail in a few places.
    const auto few = std::size_t(std::sqrt(double(mesh_.triangleCount())));
    for (const std::size_t stride : {few, std::size_t{1}}) {
      DistanceSampler sampler(*tree_);
      const auto isOnSurface = [&](const Vec3& p, double farthest) {
        return sampler.addBeyond(farthest, plane.mirrored(p)) <= farthest * farthest;
      };
      for (std::size_t t = 0; t < mesh_.triangleCount(); t += stride) {
        const auto [a, b, c] = cornersOf(mesh_, t);
        for (const Vec3& p : {a, b, c})
          if (!isOnSurface(p, tolerance_)) return false;
        // From an opening the middle of a triangle would be a third of its height away.
        const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
        const double height = 2 * area(a, b, c) / longest;
        if (!isOnSurface((a + b + c) / 3, std::max(tolerance_, height / 6)) &&
            !isCutOtherwise(plane, t))
          return false;
      }
    }
    return true;
  }

  bool isCutOtherwise(const MirrorPlane& plane, std::size_t t) {
    if (!diagonals_) diagonals_.emplace(mesh_);
    std::array<Index, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = diagonals_->first(mesh_.indices[3 * t + k]);
    return diagonals_->areTurned(triangle, [&](Index v) {
      const Vec3 p = plane.mirrored(mesh_.positions[v]);
      const Index near = tree_->nearest(p).triangle;
      for (std::size_t k = 0; k < 3; ++k)
        if (const Index w = mesh_.indices[3 * near + k];
            distance(mesh_.positions[w], p) <= tolerance_)
          return diagonals_->first(w);
      return kNone;
    });
  }

  const TriangleMesh& mesh_;
  const double tolerance_;
  const Moments moments_;
  std::optional<TriangleTree> tree_;
  std::optional<Diagonals> diagonals_;
  std::vector<MirrorPlane> planes_;
};

}  // namespace

std::vector<MirrorPlane> findMirrorPlanes(const TriangleMesh& mesh, double tolerance,
                                          const std::vector<MirrorPlane>& first) {
  return PlaneSearch(mesh, tolerance).run(first);
}

}  // namespace remesher
