// SPDX-License-Identifier: MIT
#include "textures/painting/shading.h"

#include <cmath>

#include "base/disjoint_sets.h"
#include "base/options.h"
#include "geometry/triangle.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

// Normals on the two sides of a curve that differ by more are intended to be two.
const double kHard = std::cos(radians(kFeatureAngle));
// Normals that differ from their own shape by more are intended: those of a rounded cube are 55°
// off.
const double kForeign = std::cos(radians(60));

class Shader {
 public:
  Shader(std::span<const Vec3> positions, std::span<const Index> indices, FaceKind kind)
      : positions_(positions), indices_(indices), kind_(kind), shared_(indices.size()) {}

  std::vector<CornerNormals> run(std::span<const InputPlace> places, const PaintSource& source) {
    std::vector<Vec3> original;
    for (const InputPlace& place : places) original.push_back(source.shadingNormal(place));
    const EdgeGroups edges(positions_.size(), indices_);
    const auto parts = [&](Index a, Index b) { return original[a].dot(original[b]) < kHard; };
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges[e].size() != 2) continue;
      const Index a = edges[e][0], b = edges[e][1];
      if (indices_[a] == indices_[b]) continue;
      const bool isWithin = areOneQuad(kind_, a / 3, b / 3);
      if (!isWithin && (parts(a, nextCorner(b)) || parts(nextCorner(a), b))) continue;
      shared_.unite(a, nextCorner(b));
      shared_.unite(nextCorner(a), b);
    }
    std::vector<double> agreements;
    for (Index h = 0; h < indices_.size(); ++h)
      agreements.push_back(original[h].dot(source.faceNormal(places[h].triangle)));
    const std::vector<Vec3> shapes = sharedNormals(), given = means(original);
    const std::vector<char> isForeign = foreignCorners(agreements, shapes, given);
    std::vector<CornerNormals> result;
    for (Index h = 0; h < indices_.size(); ++h)
      result.push_back({shapes[h], isForeign[h] ? given[h] : shapes[h]});
    return result;
  }

 private:
  Triangle corners(Index t) const {
    return {positions_[indices_[3 * t]], positions_[indices_[3 * t + 1]],
            positions_[indices_[3 * t + 2]]};
  }

  // The mean normal of the triangles at each shared corner, weighted by angle.
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

  // Per corner the direction of the mean over the corners shared with it.
  std::vector<Vec3> means(std::span<const Vec3> normals) {
    std::vector<Vec3> sums(normals.size(), Vec3::Zero()), result;
    for (Index h = 0; h < normals.size(); ++h) sums[shared_.find(h)] += normals[h];
    for (Index h = 0; h < normals.size(); ++h)
      result.push_back(unitOr(sums[shared_.find(h)], normals[h]));
    return result;
  }

  // Whether a corner takes the given normal: because this is far from the normals of the original's
  // shape and of the new shape there, or because most of its piece does. agreements: cosines
  // between the original's normals and its shape.
  std::vector<char> foreignCorners(std::span<const double> agreements, std::span<const Vec3> shapes,
                                   std::span<const Vec3> given) {
    std::vector<double> beyond(indices_.size(), 0);
    DisjointSets pieces = shared_;
    for (Index h = 0; h < indices_.size(); ++h) {
      beyond[shared_.find(h)] += kForeign - agreements[h];
      pieces.unite(h, nextCorner(h));
    }
    std::vector<Index> corners(indices_.size(), 0), foreign = corners;
    std::vector<char> result;
    for (Index h = 0; h < indices_.size(); ++h) {
      result.push_back(beyond[shared_.find(h)] > 0 && given[h].dot(shapes[h]) < kForeign);
      ++corners[pieces.find(h)];
      if (result[h]) ++foreign[pieces.find(h)];
    }
    // If most corners of a piece are foreign, all of them are: a triangle between both kinds would
    // be streaked, because normals turn too far over it.
    for (Index h = 0; h < indices_.size(); ++h) {
      const Index piece = pieces.find(h);
      if (2 * foreign[piece] > corners[piece]) result[h] = 1;
    }
    return result;
  }

  std::span<const Vec3> positions_;
  std::span<const Index> indices_;
  FaceKind kind_;
  DisjointSets shared_;  // corners
};

}  // namespace

std::vector<CornerNormals> shade(std::span<const Vec3> positions, std::span<const Index> indices,
                                 std::span<const InputPlace> places, const PaintSource& source,
                                 FaceKind kind) {
  return Shader(positions, indices, kind).run(places, source);
}

}  // namespace remesher
