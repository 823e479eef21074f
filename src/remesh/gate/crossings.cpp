// SPDX-License-Identifier: MIT
#include "remesh/gate/crossings.h"

#include <algorithm>

#include "geometry/predicates.h"

namespace remesher {

namespace {

// Whether an edge and a triangle have a point in common; edges in the triangle's plane are left
// out.
bool meets(const Vec3& p, const Vec3& q, const Triangle& t) {
  const auto& [a, b, c] = t;
  const int begin = orient3d(a, b, c, p), end = orient3d(a, b, c, q);
  if (begin * end > 0 || (begin == 0 && end == 0)) return false;
  const int ab = orient3d(p, q, a, b), bc = orient3d(p, q, b, c), ca = orient3d(p, q, c, a);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

Box boxOf(const Triangle& t) {
  Box box;
  for (const Vec3& p : t) box.extend(p);
  return box;
}

}  // namespace

Crossings::Crossings(const WorkingMesh& mesh) : mesh_(mesh), tree_(mesh.mesh(), mesh.positions()) {}

Crossings::Named Crossings::present(Face f) const {
  const auto v = mesh_.mesh().vertices(f);
  return {v, {mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])}};
}

// Triangles with a common edge share no more unless they lie on each other. Of triangles with a
// common corner only the edges opposite to it are tested.
bool Crossings::pass(const Named& s, const Named& t) {
  const auto has = [](const Named& triangle, Vertex v) {
    return std::find(triangle.vertices.begin(), triangle.vertices.end(), v) !=
           triangle.vertices.end();
  };
  const auto shared =
      std::count_if(s.vertices.begin(), s.vertices.end(), [&](Vertex v) { return has(t, v); });
  const auto anyMeets = [&](const Named& x, const Named& y) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (i + 1) % 3;
      if (!has(y, x.vertices[i]) && !has(y, x.vertices[k]) && meets(x.at[i], x.at[k], y.at))
        return true;
    }
    return false;
  };
  return shared < 2 && (anyMeets(s, t) || anyMeets(t, s));
}

std::size_t Crossings::count(const std::vector<Named>& triangles, const LocalChange& change) const {
  std::size_t pairs = 0;
  const auto goes = [&](Face f) {
    return std::find(change.going.begin(), change.going.end(), f) != change.going.end();
  };
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) pairs += pass(triangles[i], triangles[k]);
    const Box box = boxOf(triangles[i].at);
    const Vec3 margin = Vec3::Constant(farthest_);
    tree_.visitOverlapping({box.low - margin, box.high + margin}, [&](Face f) {
      ++looked_;
      if (goes(f)) return;
      const Named other = present(f);
      pairs += boxOf(other.at).overlaps(box) && pass(triangles[i], other);
    });
  }
  return pairs;
}

bool Crossings::grow(const LocalChange& change) const {
  const auto at = [&](Vertex v) -> const Vec3& { return positionAfter(mesh_, change, v); };
  std::vector<Named> coming, going;
  for (const auto& v : change.coming) coming.push_back({v, {at(v[0]), at(v[1]), at(v[2])}});
  const std::size_t after = count(coming, change);
  if (after == 0) return false;
  for (const Face f : change.going) going.push_back(present(f));
  return after > count(going, change);
}

void Crossings::update(Face f) {
  const Triangle now = present(f).at, before = tree_.corners(f);
  for (std::size_t i = 0; i < 3; ++i) farthest_ = std::max(farthest_, (now[i] - before[i]).norm());
}

}  // namespace remesher
