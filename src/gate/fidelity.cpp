// SPDX-License-Identifier: MIT
#include "gate/fidelity.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"

namespace remesher {

namespace {

struct Corners {
  std::array<Vec3, 3> positions;
  Vec3 normal;  // unit, zero for a triangle without area
  std::array<Vec3, 3> surfaceNormals;

  double dot(int i) const { return normal.dot(surfaceNormals[i]); }
  double worst() const { return std::min({dot(0), dot(1), dot(2)}); }
  double best() const { return std::max({dot(0), dot(1), dot(2)}); }
  std::array<double, 3> pairs() const {
    const auto& n = surfaceNormals;
    return {n[0].dot(n[1]), n[1].dot(n[2]), n[2].dot(n[0])};
  }
};

Corners cornersOf(const WorkingMesh& mesh, const std::array<Vertex, 3>& triangle,
                  const Placement& moved) {
  Corners result;
  for (int i = 0; i < 3; ++i)
    result.positions[i] = triangle[i] == kMoved ? moved.position : mesh.position(triangle[i]);
  result.normal = unitNormal(result.positions[0], result.positions[1], result.positions[2]);
  for (int i = 0; i < 3; ++i)
    result.surfaceNormals[i] = triangle[i] == kMoved
                                   ? mesh.normalFacing(moved, result.normal)
                                   : mesh.normalFacing(triangle[i], result.normal);
  return result;
}

double worstBefore(const WorkingMesh& mesh, const LocalChange& change) {
  double worst = 1;
  for (const Face f : change.going)
    worst = std::min(worst, cornersOf(mesh, mesh.mesh().vertices(f), change.place).worst());
  return worst;
}

// Whether no corner's normal leans by more than `fold` allows: all that most proposals need asking.
bool isFlat(const WorkingMesh& mesh, const std::array<Vertex, 3>& triangle, const Placement& moved,
            double fold) {
  std::array<const Vec3*, 3> p, n;
  for (int i = 0; i < 3; ++i) {
    const bool isMoved = triangle[i] == kMoved;
    const VertexKind kind = isMoved ? moved.kind : mesh.kind(triangle[i]);
    if (kind != VertexKind::Interior) return false;
    p[i] = isMoved ? &moved.position : &mesh.position(triangle[i]);
    n[i] = isMoved ? &moved.normal : &mesh.normal(triangle[i]);
  }
  const Vec3 normal = areaVector(*p[0], *p[1], *p[2]);
  return std::min({normal.dot(*n[0]), normal.dot(*n[1]), normal.dot(*n[2])}) > fold * normal.norm();
}

Verdict judgeFold(const WorkingMesh& mesh, const LocalChange& change, double fold) {
  double worst = 1;
  for (const auto& triangle : change.coming)
    if (!isFlat(mesh, triangle, change.place, fold))
      worst = std::min(worst, cornersOf(mesh, triangle, change.place).worst());
  if (worst > fold) return Verdict::Accepted;
  return worst > -1 && worst >= worstBefore(mesh, change) ? Verdict::Accepted : Verdict::FoldsOver;
}

// The two cosines that strict and loose look at.
struct Agreement {
  double pair, own;
};

Agreement agreement(const Corners& corners, Fidelity mode) {
  const auto pairs = corners.pairs();
  if (mode == Fidelity::Strict)
    return {*std::min_element(pairs.begin(), pairs.end()), corners.worst()};
  return {*std::max_element(pairs.begin(), pairs.end()), corners.best()};
}

Verdict judgeAngles(const WorkingMesh& mesh, const LocalChange& change, const FidelityRule& rule) {
  for (const auto& triangle : change.coming) {
    const auto [pair, own] = agreement(cornersOf(mesh, triangle, change.place), rule.mode);
    if (!(pair > rule.cosVertexAngle)) return Verdict::VertexAngle;
    if (!(own > rule.cosTriangleAngle)) return Verdict::TriangleAngle;
  }
  return Verdict::Accepted;
}

// A little more than what is measured as a line, whichever corner it is measured from.
constexpr double kLine = 2 * kFlattest;

Vec3 written(const Vec3& p, double grain) {
  return grain > 0 ? Vec3(p.cast<float>().cast<double>()) : p;
}

bool isLine(const Vec3& a, const Vec3& b, const Vec3& c, double grain) {
  // Far above all rounding; the third edge is no longer than the other two together.
  constexpr double kPlain = 1e-12, kPlainGrains = 1e3;
  const double longest = std::max((b - a).squaredNorm(), (c - a).squaredNorm());
  const double plain = longest * (kPlain * longest + kPlainGrains * grain * grain);
  if (areaVector(a, b, c).squaredNorm() > plain) return false;
  return flatness(written(a, grain), written(b, grain), written(c, grain)) <= kLine;
}

}  // namespace

bool flattens(const WorkingMesh& mesh, const LocalChange& change, double grain) {
  const auto at = [&](Vertex v) -> const Vec3& { return positionAfter(mesh, change, v); };
  std::ptrdiff_t coming = 0;
  for (const auto& t : change.coming) {
    const Vec3 &a = at(t[0]), &b = at(t[1]), &c = at(t[2]);
    if (!isLine(a, b, c, grain)) continue;
    if (a == b || b == c || c == a) return true;
    ++coming;
  }
  return coming > 0 &&
         coming > std::count_if(change.going.begin(), change.going.end(), [&](Face f) {
           const auto [a, b, c] = mesh.corners(f);
           return isLine(a, b, c, grain);
         });
}

FidelityRule fidelityRule(const RemeshOptions& options) {
  const Fidelity byScheme = options.scheme == Scheme::Rounds ? Fidelity::Loose : Fidelity::Fold;
  return {options.fidelity.value_or(byScheme), std::cos(radians(options.vertexAngle)),
          std::cos(radians(options.triangleAngle))};
}

Verdict judge(const WorkingMesh& mesh, const LocalChange& change, const FidelityRule& rule) {
  if (flattens(mesh, change, rule.grain)) return Verdict::FoldsOver;
  const Verdict byNormals = rule.mode == Fidelity::Fold ? judgeFold(mesh, change, rule.fold)
                                                        : judgeAngles(mesh, change, rule);
  if (byNormals != Verdict::Accepted || !rule.bound) return byNormals;
  return rule.bound->allows(mesh, change) ? Verdict::Accepted : Verdict::MaxError;
}

}  // namespace remesher
