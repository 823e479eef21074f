// SPDX-License-Identifier: MIT
#include "operators/fidelity.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"
#include "operators/angles.h"

namespace remesher {

namespace {

// Triangles with a smaller angle are poor. For the sake of a better shape a cosine may be worse by
// a little.
constexpr double kPoor = radians(8);
constexpr double kLittleWorse = 0.02;

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
  double pair = 1, own = 1;

  void lower(const Agreement& other) {
    pair = std::min(pair, other.pair);
    own = std::min(own, other.own);
  }
};

Agreement agreement(const Corners& corners, Fidelity mode) {
  const auto pairs = corners.pairs();
  if (mode == Fidelity::Strict)
    return {*std::min_element(pairs.begin(), pairs.end()), corners.worst()};
  return {*std::max_element(pairs.begin(), pairs.end()), corners.best()};
}

Verdict verdictOn(const Agreement& agreement, const FidelityRule& rule) {
  if (!(agreement.pair > rule.cosVertexAngle)) return Verdict::VertexAngle;
  return agreement.own > rule.cosTriangleAngle ? Verdict::Accepted : Verdict::TriangleAngle;
}

// Where the original itself breaks the rule nothing would ever change: there what makes a poor
// triangle better will do, if it hardly disagrees with the original more than what is there. But no
// collapse: what the rule keeps from vanishing stays.
bool isWayForward(const WorkingMesh& mesh, const LocalChange& change, const FidelityRule& rule,
                  const Agreement& coming) {
  const double before = smallestGoingAngle(mesh, change);
  if (change.operation == Operation::Collapse || before > kPoor) return false;
  Agreement going;
  for (const Face f : change.going)
    going.lower(agreement(cornersOf(mesh, mesh.mesh().vertices(f), change.place), rule.mode));
  if (verdictOn(going, rule) == Verdict::Accepted) return false;
  return coming.pair >= std::min(going.pair, rule.cosVertexAngle) - kLittleWorse &&
         coming.own >= std::min(going.own, rule.cosTriangleAngle) - kLittleWorse &&
         smallestComingAngle(mesh, change) > before;
}

Verdict judgeAngles(const WorkingMesh& mesh, const LocalChange& change, const FidelityRule& rule) {
  Agreement coming;
  for (const auto& triangle : change.coming)
    coming.lower(agreement(cornersOf(mesh, triangle, change.place), rule.mode));
  const Verdict verdict = verdictOn(coming, rule);
  if (verdict == Verdict::Accepted || !isWayForward(mesh, change, rule, coming)) return verdict;
  return Verdict::Accepted;
}

}  // namespace

FidelityRule fidelityRule(const RemeshOptions& options) {
  const Fidelity byScheme = options.scheme == Scheme::Rounds ? Fidelity::Loose : Fidelity::Fold;
  return {options.fidelity.value_or(byScheme), std::cos(radians(options.vertexAngle)),
          std::cos(radians(options.triangleAngle))};
}

Verdict judge(const WorkingMesh& mesh, const LocalChange& change, const FidelityRule& rule) {
  const Verdict byNormals = rule.mode == Fidelity::Fold ? judgeFold(mesh, change, rule.fold)
                                                        : judgeAngles(mesh, change, rule);
  if (byNormals != Verdict::Accepted || !rule.bound) return byNormals;
  return rule.bound->allows(mesh, change) ? Verdict::Accepted : Verdict::MaxError;
}

}  // namespace remesher
