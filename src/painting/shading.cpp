// SPDX-License-Identifier: MIT
#include "painting/shading.h"

#include <cmath>

#include "base/disjoint_sets.h"
#include "geometry/triangle.h"
#include "soup/edge_groups.h"

namespace remesher {

namespace {

// Normals on the two sides of a curve that are farther apart were meant to be two.
const double kHard = std::cos(radians(30));
// Normals farther than this from their own shape were meant to be: a cube's, rounded, are 55° off.
const double kForeign = std::cos(radians(60));

class Shader {
 public:
  Shader(std::span<const Vec3> positions, std::span<const Index> indices)
      : positions_(positions), indices_(indices), shared_(indices.size()) {}

  std::vector<CornerNormals> run(std::span<const InputPlace> places, const PaintSource& source) {
    std::vector<Vec3> original;
    for (const InputPlace& place : places) original.push_back(source.shadingNormal(place));
    const EdgeGroups edges(positions_.size(), indices_);
    const auto parts = [&](Index a, Index b) { return original[a].dot(original[b]) < kHard; };
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges[e].size() != 2) continue;
      const Index a = edges[e][0], b = edges[e][1];
      if (indices_[a] == indices_[b]) continue;
      if (parts(a, nextCorner(b)) || parts(nextCorner(a), b)) continue;
      shared_.unite(a, nextCorner(b));
      shared_.unite(nextCorner(a), b);
    }
    std::vector<CornerNormals> result;
    const std::vector<Vec3> given = foreignNormals(original, places, source);
    for (const Vec3& shape : sharedNormals()) {
      const Vec3& light = given[shared_.find(Index(result.size()))];
      const bool isForeign = !light.isZero() && light.dot(shape) < kForeign;
      result.push_back({shape, isForeign ? light : shape});
    }
    return result;
  }

 private:
  Triangle corners(Index t) const {
    return {positions_[indices_[3 * t]], positions_[indices_[3 * t + 1]],
            positions_[indices_[3 * t + 2]]};
  }

  // The mean over the triangles that share them, weighted by their angles.
  std::vector<Vec3> sharedNormals() {
    std::vector<Vec3> sums(indices_.size(), Vec3::Zero()), result;
    for (Index t = 0; 3 * t < indices_.size(); ++t) {
      const auto [a, b, c] = corners(t);
      const std::array<double, 3> weights = angles(a, b, c);
      for (Index k = 0; k < 3; ++k)
        sums[shared_.find(3 * t + k)] += weights[k] * unitNormal(a, b, c);
    }
    for (Index h = 0; h < indices_.size(); ++h) {
      const Vec3& sum = sums[shared_.find(h)];
      const auto [a, b, c] = corners(h / 3);
      const Vec3 own = unitNormal(a, b, c);
      const double length = sum.norm();
      result.push_back(length > 0 ? Vec3(sum / length) : own.isZero() ? Vec3(Vec3::UnitZ()) : own);
    }
    return result;
  }

  // By the first of the corners that share it, the mean of the original's normals there; zero where
  // the original's shape has it, too.
  std::vector<Vec3> foreignNormals(std::span<const Vec3> original,
                                   std::span<const InputPlace> places, const PaintSource& source) {
    std::vector<Vec3> sums(indices_.size(), Vec3::Zero());
    std::vector<double> beyond(indices_.size(), 0);  // how much less than allowed normals agree
    for (Index h = 0; h < indices_.size(); ++h) {
      sums[shared_.find(h)] += original[h];
      beyond[shared_.find(h)] += kForeign - original[h].dot(source.faceNormal(places[h].triangle));
    }
    for (Index h = 0; h < indices_.size(); ++h)
      sums[h] = beyond[h] > 0 ? sums[h].stableNormalized() : Vec3(Vec3::Zero());
    return sums;
  }

  std::span<const Vec3> positions_;
  std::span<const Index> indices_;
  DisjointSets shared_;  // corners
};

}  // namespace

std::vector<CornerNormals> shade(std::span<const Vec3> positions, std::span<const Index> indices,
                                 std::span<const InputPlace> places, const PaintSource& source) {
  return Shader(positions, indices).run(places, source);
}

}  // namespace remesher
