// SPDX-License-Identifier: MIT
#include "remesh/gate/fidelity.h"

#include <algorithm>
#include <cmath>

#include "geometry/extremes.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

struct Corners {
  std::array<Vec3, 3> positions;
  Vec3 normal;  // unit, zero for a triangle without area
  std::array<Vec3, 3> surfaceNormals;

  double dot(int i) const { return normal.dot(surfaceNormals[i]); }
  double worst() const { return least(dot(0), dot(1), dot(2)); }
  double best() const { return greatest(dot(0), dot(1), dot(2)); }
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

// A little above kFlattest, so that a line counts as one from whichever corner it is measured.
constexpr double kLine = 2 * kFlattest;

// Whether a triangle is surely no line, far above all rounding. longer: the square of the longer of
// two sides; area: the square of twice its area. The third side is no longer than the other two
// together.
bool isPlain(double longer, double area, const Quantum& quantum) {
  constexpr double kPlain = 1e-12, kPlainQuanta = 1e3;
  return area > longer * (kPlain * longer + kPlainQuanta * quantum.size * quantum.size);
}

// Whether a triangle surely is no fold. lean: the least product of its area vector with the normals
// of its corners; squared: the square of its area vector.
bool isUpright(double lean, double squared, const FidelityRule& rule) {
  // Rounding changes no answer.
  return lean > 0 && lean * lean > (1 + kRoundOff) * rule.fold * rule.fold * squared;
}

// A quick test that a triangle is far from a line and from a fold; most proposals need no more. At
// a corner where curves meet it uses the normal of one side: the normal of the side that the
// triangle faces can only be better.
bool isFine(const WorkingMesh& mesh, const std::array<Vertex, 3>& triangle, const Placement& moved,
            const FidelityRule& rule) {
  std::array<const Vec3*, 3> p, n;
  for (int i = 0; i < 3; ++i) {
    const bool isMoved = triangle[i] == kMoved;
    p[i] = isMoved ? &moved.position : &mesh.position(triangle[i]);
    n[i] = isMoved ? &moved.normal : &mesh.normal(triangle[i]);
  }
  const Vec3 ab = *p[1] - *p[0], ac = *p[2] - *p[0], normal = ab.cross(ac);
  const double squared = normal.squaredNorm();
  const auto isFold = [&](double lean) { return !isUpright(lean, squared, rule); };
  const bool isFolded = isFold(least(normal.dot(*n[0]), normal.dot(*n[1]), normal.dot(*n[2])));
  for (int i = 0; isFolded && i < 3; ++i) {
    if (!isFold(normal.dot(*n[i]))) continue;
    const bool isMoved = triangle[i] == kMoved;
    if ((isMoved ? moved.kind : mesh.kind(triangle[i])) != VertexKind::Curve) return false;
    if (isFold(normal.dot(isMoved ? moved.across : mesh.normalAcross(triangle[i])))) return false;
  }
  return isPlain(greatest(ab.squaredNorm(), ac.squaredNorm()), squared, rule.quantum);
}

// The smallest N_i·N_T of a triangle; if none is a fold, any value above `fold`. The normals of the
// other sides of a curve are computed only where they matter.
double worstLean(const WorkingMesh& mesh, const std::array<Vertex, 3>& triangle,
                 const Placement& moved, double fold) {
  std::array<Vec3, 3> p;
  for (int i = 0; i < 3; ++i)
    p[i] = triangle[i] == kMoved ? moved.position : mesh.position(triangle[i]);
  const Vec3 normal = unitNormal(p[0], p[1], p[2]);
  double worst = 1;
  for (const Vertex v : triangle) {
    const bool isMoved = v == kMoved;
    double lean = normal.dot(isMoved ? moved.normal : mesh.normal(v));
    if (lean <= fold)
      lean = normal.dot(isMoved ? mesh.normalFacing(moved, normal) : mesh.normalFacing(v, normal));
    worst = std::min(worst, lean);
  }
  return worst;
}

// Whether a coming triangle would face away from all triangles that the change replaces. Between
// curves the corners' normals say too little: a triangle face down in a flat cap leans no more than
// the walls around the cap.
bool turnsOver(const WorkingMesh& mesh, const LocalChange& change) {
  const auto at = [&](Vertex v) -> const Vec3& { return positionAfter(mesh, change, v); };
  return std::any_of(change.coming.begin(), change.coming.end(), [&](const auto& t) {
    const Vec3 normal = unitNormal(at(t[0]), at(t[1]), at(t[2]));
    return std::all_of(change.going.begin(), change.going.end(), [&](Face f) {
      const auto [a, b, c] = mesh.corners(f);
      return normal.dot(unitNormal(a, b, c)) < kTightFold;
    });
  });
}

Verdict judgeFold(const WorkingMesh& mesh, const LocalChange& change, const FidelityRule& rule) {
  double worst = 1;
  for (const auto& triangle : change.coming)
    if (!isFine(mesh, triangle, change.place, rule))
      worst = std::min(worst, worstLean(mesh, triangle, change.place, rule.fold));
  if (worst > kFold) return Verdict::Accepted;
  if (turnsOver(mesh, change)) return Verdict::FoldsOver;
  if (worst > rule.fold) return Verdict::Accepted;
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

// Judges the triangles' shape and orientation, without the guard and the bound.
Verdict judgeShape(const WorkingMesh& mesh, const LocalChange& change, const FidelityRule& rule) {
  const bool isFold = rule.mode == Fidelity::Fold;
  const auto isFineOne = [&](const std::array<Vertex, 3>& triangle) {
    return isFine(mesh, triangle, change.place, rule);
  };
  if (isFold && std::all_of(change.coming.begin(), change.coming.end(), isFineOne))
    return Verdict::Accepted;
  if (flattens(mesh, change, rule.quantum)) return Verdict::FoldsOver;
  return isFold ? judgeFold(mesh, change, rule) : judgeAngles(mesh, change, rule);
}

}  // namespace

bool isLine(const Triangle& triangle, const Quantum& quantum) {
  const auto& [a, b, c] = triangle;
  const double longer = greatest((b - a).squaredNorm(), (c - a).squaredNorm());
  if (isPlain(longer, areaVector(a, b, c).squaredNorm(), quantum)) return false;
  // Rounding also bends lines, where a file holds more digits.
  return std::min(flatness(a, b, c),
                  flatness(written(a, quantum), written(b, quantum), written(c, quantum))) <= kLine;
}

bool flattens(const WorkingMesh& mesh, const LocalChange& change, const Quantum& quantum) {
  const auto at = [&](Vertex v) -> const Vec3& { return positionAfter(mesh, change, v); };
  const auto areOne = [&](const Vec3& a, const Vec3& b) {
    return written(a, quantum) == written(b, quantum);
  };
  std::ptrdiff_t coming = 0;
  for (const auto& t : change.coming) {
    const Vec3 &a = at(t[0]), &b = at(t[1]), &c = at(t[2]);
    if (!isLine({a, b, c}, quantum)) continue;
    if (areOne(a, b) || areOne(b, c) || areOne(c, a)) return true;
    ++coming;
  }
  return coming > 0 &&
         coming > std::count_if(change.going.begin(), change.going.end(),
                                [&](Face f) { return isLine(mesh.corners(f), quantum); });
}

FidelityRule fidelityRule(const RemeshOptions& options) {
  const Fidelity byScheme = options.scheme == Scheme::Rounds ? Fidelity::Loose : Fidelity::Fold;
  return {options.fidelity.value_or(byScheme), std::cos(radians(options.vertexAngle)),
          std::cos(radians(options.triangleAngle))};
}

bool mayMove(const Star& star, const Placement& place, const FidelityRule& rule) {
  if (rule.mode != Fidelity::Fold || rule.bound || rule.guard) return false;
  const std::size_t last = star.size() - 1;
  Vec3 before = star.position(last) - place.position;
  double length2Before = before.squaredNorm();
  for (std::size_t i = 0, k = last; i <= last; k = i++) {
    const Vec3 spoke = star.position(i) - place.position, normal = before.cross(spoke);
    const double length2 = spoke.squaredNorm(), squared = normal.squaredNorm();
    const double lean =
        least(normal.dot(place.normal), normal.dot(star.normal(k)), normal.dot(star.normal(i)));
    if (!isUpright(lean, squared, rule)) return false;
    if (!isPlain(greatest(length2Before, length2), squared, rule.quantum)) return false;
    before = spoke;
    length2Before = length2;
  }
  return true;
}

Verdict judge(const WorkingMesh& mesh, const LocalChange& change, const FidelityRule& rule) {
  const Verdict byShape = judgeShape(mesh, change, rule);
  if (byShape != Verdict::Accepted) return byShape;
  if (rule.guard && !rule.guard->allows(change)) return Verdict::Crosses;
  return !rule.bound || rule.bound->allows(mesh, change) ? Verdict::Accepted : Verdict::MaxError;
}

}  // namespace remesher
