// SPDX-License-Identifier: MIT
#include "contact/flat_faces.h"

#include <algorithm>
#include <map>

#include "base/disjoint_sets.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

// Neighbours in one face differ by less than this cosine.
constexpr double kAlike = 0.98;
// A plane through one small triangle is vague far away from it: it is fitted anew so often.
constexpr int kFits = 6;

class FaceGrowing {
 public:
  FaceGrowing(const BodySoup& soup, double tolerance) : soup_(soup), tolerance_(tolerance) {
    result_.ofTriangle.assign(soup.triangles.size(), kNone);
    foundIn_.assign(soup.triangles.size(), 0);
  }

  // Seeds: the largest first, for their planes are the surest.
  FlatFaces run(std::vector<Index> seeds) {
    std::stable_sort(seeds.begin(), seeds.end(),
                     [this](Index a, Index b) { return vectorOf(a).norm() > vectorOf(b).norm(); });
    for (const Index seed : seeds)
      if (result_.ofTriangle[seed] == kNone) grow(seed);
    for (FlatFace& face : result_.faces) setBorder(face);
    return std::move(result_);
  }

 private:
  Vec3 vectorOf(Index t) const {
    return areaVector(soup_.at(t, 0), soup_.at(t, 1), soup_.at(t, 2));
  }

  void grow(Index seed) {
    FlatFace face;
    fit(face, {seed});
    face.triangles = flood(face, seed);
    for (int i = 0; i < kFits; ++i) {
      FlatFace next;
      fit(next, face.triangles);
      next.triangles = flood(next, seed);
      if (next.triangles.size() <= face.triangles.size()) break;
      face = std::move(next);
    }
    for (const Index t : face.triangles) result_.ofTriangle[t] = Index(result_.faces.size());
    result_.faces.push_back(std::move(face));
  }

  void fit(FlatFace& face, const std::vector<Index>& triangles) const {
    double area = 0;
    for (const Index t : triangles) {
      const Vec3 vector = vectorOf(t);
      const double own = vector.norm();
      face.normal += vector;
      face.origin += own / 3 * (soup_.at(t, 0) + soup_.at(t, 1) + soup_.at(t, 2));
      area += own;
    }
    if (area > 0) face.origin /= area;
    face.normal.stableNormalize();
  }

  std::vector<Index> flood(const FlatFace& face, Index seed) {
    std::vector<Index> found = {seed};
    foundIn_[seed] = ++floods_;
    for (std::size_t i = 0; i < found.size(); ++i)
      for (Index k = 0; k < 3; ++k) {
        const Index mate = soup_.mates[3 * found[i] + k];
        if (mate == kNone || foundIn_[mate / 3] == floods_ || !isIn(face, mate / 3, seed)) continue;
        foundIn_[mate / 3] = floods_;
        found.push_back(mate / 3);
      }
    return found;
  }

  bool isIn(const FlatFace& face, Index t, Index seed) const {
    if (result_.ofTriangle[t] != kNone || soup_.triangles[t].group != soup_.triangles[seed].group)
      return false;
    const Vec3 vector = vectorOf(t);
    if (vector.dot(face.normal) <= kAlike * vector.norm()) return false;
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(face.normal.dot(soup_.at(t, k) - face.origin)) > tolerance_) return false;
    return true;
  }

  void setBorder(FlatFace& face) const {
    std::sort(face.triangles.begin(), face.triangles.end());
    for (const Index t : face.triangles)
      for (Index k = 0; k < 3; ++k) {
        const Index mate = soup_.mates[3 * t + k];
        if (mate == kNone || result_.ofTriangle[mate / 3] != result_.ofTriangle[t])
          face.border.push_back(3 * t + k);
      }
  }

  const BodySoup& soup_;
  const double tolerance_;
  std::vector<Index> foundIn_;  // per triangle the last flood that found it, counted from 1
  Index floods_ = 0;
  FlatFaces result_;
};

}  // namespace

FlatFaces flatFacesOf(const BodySoup& soup, const std::vector<std::pair<Index, Index>>& touching,
                      double tolerance) {
  std::vector<Index> seeds;
  for (const auto& [s, t] : touching) seeds.insert(seeds.end(), {s, t});
  std::sort(seeds.begin(), seeds.end());
  seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
  FlatFaces result = FaceGrowing(soup, tolerance).run(std::move(seeds));
  DisjointSets sets(result.faces.size());
  for (const auto& [s, t] : touching) sets.unite(result.ofTriangle[s], result.ofTriangle[t]);
  std::map<Index, std::vector<Index>> byFirst;
  for (Index f = 0; f < result.faces.size(); ++f) byFirst[sets.find(f)].push_back(f);
  for (auto& [first, cluster] : byFirst) result.clusters.push_back(std::move(cluster));
  return result;
}

}  // namespace remesher
