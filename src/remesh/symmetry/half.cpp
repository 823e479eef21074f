// SPDX-License-Identifier: MIT
#include "remesh/symmetry/half.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/triangle.h"

namespace remesher {

namespace {

// A corner of a piece: a vertex, and its weights on the triangle of the whole.
struct PieceCorner {
  Index vertex;
  Vec3 weights;
};

class PlaneCut {
 public:
  PlaneCut(Half half, const MirrorPlane& plane, double slack)
      : old_(std::move(half)), plane_(plane), sides_(old_.mesh.positions.size()) {
    made_.mesh.isSingle = old_.mesh.isSingle;
    made_.mesh.frame = old_.mesh.frame;
    for (std::size_t v = 0; v < sides_.size(); ++v) {
      const double distance = plane.distance(old_.mesh.positions[v]);
      sides_[v] = distance > slack ? distance : distance < -slack ? distance : 0;
    }
    numbers_.assign(sides_.size(), kNone);
  }

  std::optional<Half> run(InPlane inPlane) {
    for (std::size_t t = 0; t < old_.mesh.triangleCount(); ++t) {
      std::array<double, 3> sides{};
      for (std::size_t k = 0; k < 3; ++k) sides[k] = sides_[old_.mesh.indices[3 * t + k]];
      const auto [low, high] = std::minmax_element(sides.begin(), sides.end());
      if (*low == 0 && *high == 0 && inPlane == InPlane::Refused) return {};
      if (*high > 0) addPiece(t);
    }
    if (made_.mesh.indices.empty()) return {};
    return std::move(made_);
  }

 private:
  void addPiece(std::size_t t) {
    std::vector<PieceCorner> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const Index a = old_.mesh.indices[3 * t + k], b = old_.mesh.indices[3 * t + next];
      const Vec3 &atA = old_.places[t][k].weights, &atB = old_.places[t][next].weights;
      if (sides_[a] >= 0) corners.push_back({kept(a), atA});
      if (sides_[a] * sides_[b] >= 0) continue;
      const double share = sides_[a] / (sides_[a] - sides_[b]);
      corners.push_back({crossing(a, b, t), (1 - share) * atA + share * atB});
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
      std::array<InputPlace, 3> places;
      const std::array<std::size_t, 3> own = {0, i - 1, i};
      for (std::size_t k = 0; k < 3; ++k) {
        made_.mesh.indices.push_back(corners[own[k]].vertex);
        places[k] = {old_.places[t][0].triangle, corners[own[k]].weights};
      }
      made_.places.push_back(places);
      if (!old_.mesh.groups.empty()) made_.mesh.groups.push_back(old_.mesh.groups[t]);
    }
  }

  Index add(const Vec3& p, const InputPlace& place) {
    made_.mesh.positions.push_back(p);
    made_.vertices.push_back(place);
    return Index(made_.mesh.positions.size() - 1);
  }

  Index kept(Index v) {
    if (numbers_[v] == kNone) {
      const Vec3& p = old_.mesh.positions[v];
      numbers_[v] = add(sides_[v] == 0 ? plane_.onto(p) : p, old_.vertices[v]);
    }
    return numbers_[v];
  }

  // Where the edge from a to b meets the plane: the same place from both its triangles, and for
  // copies of its vertices.
  Index crossing(Index a, Index b, std::size_t t) {
    const Vec3 *from = &old_.mesh.positions[a], *to = &old_.mesh.positions[b];
    if (sides_[a] < 0) {
      std::swap(from, to);
      std::swap(a, b);
    }
    const auto [known, isNew] = crossings_.try_emplace({a, b}, kNone);
    if (!isNew) return known->second;
    const double share = sides_[a] / (sides_[a] - sides_[b]);
    InputPlace place{old_.places[t][0].triangle, Vec3::Zero()};
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = old_.mesh.indices[3 * t + k];
      if (v == a) place.weights += (1 - share) * old_.places[t][k].weights;
      if (v == b) place.weights += share * old_.places[t][k].weights;
    }
    return known->second = add(plane_.onto((1 - share) * *from + share * *to), place);
  }

  const Half old_;
  const MirrorPlane plane_;
  std::vector<double> sides_;  // per vertex its distance, 0 on the plane
  std::vector<Index> numbers_;
  std::map<std::pair<Index, Index>, Index> crossings_;
  Half made_;
};

Half wholeOf(const TriangleMesh& whole) {
  Half half;
  half.mesh.positions = whole.positions;
  half.mesh.isSingle = whole.isSingle;
  half.mesh.frame = whole.frame;
  half.vertices.resize(whole.positions.size());
  for (Index t = 0; t < whole.triangleCount(); ++t) {
    const Index* const own = &whole.indices[std::size_t{3} * t];
    if (hasTwins(whole.positions[own[0]], whole.positions[own[1]], whole.positions[own[2]]))
      continue;
    std::array<InputPlace, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = {InputTriangle(t), Vec3::Unit(Eigen::Index(k))};
      half.vertices[own[k]] = corners[k];
      half.mesh.indices.push_back(own[k]);
    }
    half.places.push_back(corners);
    if (!whole.groups.empty()) half.mesh.groups.push_back(whole.groups[t]);
  }
  return half;
}

}  // namespace

std::optional<Half> inFrontOf(const Mirrors& mirrors, const TriangleMesh& whole, InPlane inPlane) {
  std::optional<Half> half = wholeOf(whole);
  for (const MirrorPlane& plane : mirrors.planes) {
    half = PlaneCut(std::move(*half), plane, mirrors.slack).run(inPlane);
    if (!half) return {};
  }
  return half;
}

}  // namespace remesher
