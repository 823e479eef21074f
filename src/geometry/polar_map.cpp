// SPDX-License-Identifier: MIT
#include "geometry/polar_map.h"

#include <cmath>
#include <numbers>

#include "geometry/fast_trigonometry.h"

namespace remesher {

namespace {

double angleBetween(const Vec3& a, const Vec3& b) {
  const double sine = a.cross(b).norm(), cosine = a.dot(b);
  return sine > 0 || cosine != 0 ? angleOf(sine, cosine) : 0;
}

}  // namespace

void PolarMap::build(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, Vertex v) {
  center_ = v;
  neighbors_.clear();
  spokes_.clear();
  const Vec3& center = positions[v];
  mesh.forEachNeighbor(v, [&](Vertex n) {
    neighbors_.push_back(n);
    spokes_.push_back(positions[n] - center);
  });
  const std::size_t n = neighbors_.size();
  rim_.resize(n);
  double total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    rim_[i].x() = total;
    total += angleBetween(spokes_[i], spokes_[i + 1 == n ? 0 : i + 1]);
  }
  const double scale = total > 0 ? 2 * std::numbers::pi / total : 0;
  for (std::size_t i = 0; i < n; ++i) {
    rim_[i] = spokes_[i].norm() * onUnitCircle(scale * rim_[i].x());
  }
}

double PolarMap::meanSpoke() const {
  double mean = 0;
  for (const Vec2& p : rim_) mean += p.norm() / size();
  return mean;
}

std::optional<PolarMap::Location> PolarMap::locate(const Vec2& p) const {
  for (int i = 0; i < size(); ++i) {
    const Vec2 &a = rim_[i], &b = rim_[after(i)];
    const double whole = cross(a, b), atA = cross(p, b), atB = cross(a, p);
    if (whole <= 0 || atA < 0 || atB < 0 || atA + atB > whole) continue;
    return Location{i, Vec3(whole - atA - atB, atA, atB) / whole};
  }
  return std::nullopt;
}

UnfoldedEdge unfold(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, Halfedge h) {
  const Vec3& a = positions[mesh.origin(h)];
  const Vec3 ab = positions[mesh.tip(h)] - a;
  const Vec3 ac = positions[mesh.opposite(h)] - a, ad = positions[mesh.opposite(mesh.twin(h))] - a;
  const double length = ab.norm();
  if (!(length > 0)) return {Vec2::Zero(), Vec2::Zero(), Vec2(0, ac.norm()), Vec2(0, -ad.norm())};
  return {Vec2::Zero(), Vec2(length, 0), Vec2(ab.dot(ac), ab.cross(ac).norm()) / length,
          Vec2(ab.dot(ad), -ab.cross(ad).norm()) / length};
}

bool isLocallyDelaunay(const UnfoldedEdge& quad) {
  // The angles at c and d sum to at most π. A cosine and a sine of each, up to a positive factor:
  const Vec2 ca = quad.a - quad.c, cb = quad.b - quad.c, da = quad.a - quad.d, db = quad.b - quad.d;
  const double cosC = ca.dot(cb), sinC = cross(ca, cb), cosD = da.dot(db), sinD = cross(db, da);
  // A flip must gain more than rounding, or two cocircular triangles would swap for ever.
  const double sinSum = sinC * cosD + cosC * sinD;
  return sinSum >= -kRoundOff * (ca.norm() * cb.norm() * da.norm() * db.norm());
}

}  // namespace remesher
