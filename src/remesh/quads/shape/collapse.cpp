// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/collapse.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <optional>
#include <set>
#include <tuple>

#include "geometry/quad.h"
#include "original/surface/surface_walk.h"
#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/quads/mesh/quad_sides.h"

namespace remesher {

namespace {

// A quad that is taken out makes vertices irregular; those beside it in its row then make no more:
// runs of about so many are taken out, from one end to the other.
constexpr std::size_t kLongRun = 48;
constexpr int kAnyIrregular = std::numeric_limits<int>::max();

// A corner of a quad to be merged with the opposite corner.
struct Candidate {
  int irregular;  // the rise of the summed distances of valences from 4
  double length;  // of the diagonal
  Index side;     // the side that leaves the corner
  auto order() const { return std::tie(irregular, length, side); }
  bool operator<(const Candidate& other) const { return order() < other.order(); }
};

class QuadCollapses {
 public:
  QuadCollapses(const QuadMesh& mesh, int mostIrregular)
      : mesh_(mesh), sides_(mesh.vertices.size(), mesh.quads), mostIrregular_(mostIrregular) {}

  std::vector<Candidate> ofQuads() const {
    std::vector<Candidate> found;
    for (Index q = 0; q < mesh_.quads.size(); ++q)
      for (Index corner = 0; corner < 2; ++corner)
        if (const auto candidate = judge(sideOf(q, corner))) found.push_back(*candidate);
    std::sort(found.begin(), found.end());
    return found;
  }

  // Candidates that make no quad worse than 12° that was better.
  std::vector<Candidate> ofSoundQuads() const {
    std::vector<Candidate> found = ofQuads();
    const auto isFolding = [&](const Candidate& candidate) {
      return foldsQuad(sides_.origin(candidate.side), sides_.tip(nextSide(candidate.side)));
    };
    found.erase(std::remove_if(found.begin(), found.end(), isFolding), found.end());
    return found;
  }

  // Candidates that remove a corner with both sides on curves: a corner of about half a turn.
  std::vector<Candidate> ofFlatCorners() const {
    std::vector<Candidate> found;
    for (Index side = 0; side < 4 * mesh_.quads.size(); ++side)
      if (isFlatCorner(side))
        if (const auto candidate = judge(side)) found.push_back(*candidate);
    std::sort(found.begin(), found.end());
    return found;
  }

  // All vertices of the quads around the four corners: nothing else may change them at the same
  // time.
  std::vector<Index> reachOf(Index side) const {
    std::vector<Index> reach;
    for (const Index v : mesh_.quads[side / 4])
      sides_.forEachOutgoing(v, [&](Index out) {
        for (const Index w : mesh_.quads[out / 4]) reach.push_back(w);
      });
    return reach;
  }

 private:
  std::set<Index> neighbors(Index v) const {
    std::set<Index> found;
    sides_.forEachOutgoing(v, [&](Index side) {
      found.insert(sides_.tip(side));
      found.insert(sides_.origin(prevSide(side)));
    });
    return found;
  }

  std::set<Index> aroundQuads(Index v) const {
    std::set<Index> found;
    sides_.forEachOutgoing(v, [&](Index side) {
      for (const Index w : mesh_.quads[side / 4]) found.insert(w);
    });
    return found;
  }

  bool isCurve(Index side) const { return mesh_.curves[side / 4][side % 4] != kNone; }

  // Whether the corner that a side leaves is flat.
  bool isFlatCorner(Index side) const {
    return isCurve(side) && isCurve(prevSide(side)) &&
           mesh_.vertices[sides_.origin(side)].kind == VertexKind::Curve;
  }

  // Whether b may lose a neighbour: an inner vertex keeps three, a boundary vertex keeps a quad.
  bool mayLose(Index b) const {
    return sides_.valence(b) > 3 || (sides_.isBoundary(b) && sides_.valence(b) > 2);
  }

  std::optional<Candidate> judge(Index side) const {
    const Index a = sides_.origin(side), b = sides_.tip(side);
    const Index c = sides_.tip(nextSide(side)), d = sides_.origin(prevSide(side));
    // At most one of the two is not free to move, so that no curve is carried onto another.
    if (mesh_.vertices[a].kind != VertexKind::Interior &&
        mesh_.vertices[c].kind != VertexKind::Interior)
      return {};
    if (!mayLose(b) || !mayLose(d)) return {};
    for (Index k = 0, s = side; k < 4; ++k, s = nextSide(s))
      if (sides_.across(s) == kNone) return {};
    const int va = sides_.valence(a), vb = sides_.valence(b), vc = sides_.valence(c),
              vd = sides_.valence(d);
    const int before = std::abs(va - 4) + std::abs(vb - 4) + std::abs(vc - 4) + std::abs(vd - 4);
    int after = std::abs(va + vc - 6) + std::abs(vb - 5) + std::abs(vd - 5);
    // On curves quads on both sides count, not their sum.
    for (const Index v : {a, b, c, d}) after += mesh_.vertices[v].kind != VertexKind::Interior;
    if (after - before > mostIrregular_) return {};
    const std::set<Index> ofA = neighbors(a), ofC = neighbors(c);
    for (const Index v : ofA)
      if (v != b && v != d && ofC.contains(v)) return {};
    std::size_t shared = 0;
    const std::set<Index> aroundC = aroundQuads(c);
    for (const Index v : aroundQuads(a)) shared += aroundC.contains(v);
    if (shared != 4) return {};
    return Candidate{after - before, (mesh_.position(a) - mesh_.position(c)).norm(), side};
  }

  // Whether a quad around the merged a and c gets worse than 12° and worse than before.
  bool foldsQuad(Index a, Index c) const {
    const VertexKind kindA = mesh_.vertices[a].kind, kindC = mesh_.vertices[c].kind;
    const Vec3 &p = mesh_.position(a), &q = mesh_.position(c);
    const Vec3 place = kindA != VertexKind::Interior   ? p
                       : kindC != VertexKind::Interior ? q
                                                       : Vec3((p + q) / 2);
    bool isFound = false;
    for (const Index v : {a, c})
      sides_.forEachOutgoing(v, [&](Index side) {
        const Four<Index>& quad = mesh_.quads[side / 4];
        const auto has = [&](Index w) {
          return std::find(quad.begin(), quad.end(), w) != quad.end();
        };
        if (has(a) && has(c)) return;
        Quad corners{};
        for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh_.position(quad[i]);
        const double before = leastSine(corners);
        corners[side % 4] = place;
        isFound |= leastSine(corners) < std::min(before, kLeastSine);
      });
    return isFound;
  }

  const QuadMesh& mesh_;
  const QuadSides sides_;
  const int mostIrregular_;
};

Placement merged(const Placement& a, const Placement& c, const WorkingMesh& ground) {
  if (a.kind != VertexKind::Interior) return a;
  if (c.kind != VertexKind::Interior) return c;
  return ground.onSurface(closestPointFrom(ground.surface(), a.at, (a.position + c.position) / 2));
}

// The partners of two sides of a removed quad become one edge, on the curve of either.
void joinCurves(QuadMesh& mesh, const QuadSides& sides, Index one, Index two) {
  const Index a = sides.across(one), b = sides.across(two);
  Index &curveA = mesh.curves[a / 4][a % 4], &curveB = mesh.curves[b / 4][b % 4];
  if (curveA == kNone) curveA = curveB;
  curveB = curveA;
}

using Candidates = std::vector<Candidate> (QuadCollapses::*)() const;

// Carries out as many of the candidates as may be done side by side, of those that do not make
// vertices more irregular than this.
std::size_t collapseOnce(QuadMesh& mesh, const WorkingMesh& ground, Candidates candidates,
                         std::size_t most, int mostIrregular = kAnyIrregular) {
  const QuadMesh before = mesh;
  const QuadCollapses collapses(before, mostIrregular);
  const QuadSides sides(before.vertices.size(), before.quads);
  std::vector<char> isTouched(before.vertices.size(), 0), isGone(before.quads.size(), 0);
  std::vector<Index> collapsedInto(before.vertices.size());
  for (Index v = 0; v < collapsedInto.size(); ++v) collapsedInto[v] = v;
  std::size_t count = 0;
  for (const Candidate& candidate : (collapses.*candidates)()) {
    if (count == most) break;
    const std::vector<Index> reach = collapses.reachOf(candidate.side);
    if (std::any_of(reach.begin(), reach.end(), [&](Index v) { return isTouched[v] != 0; }))
      continue;
    for (const Index v : reach) isTouched[v] = 1;
    const Index side = candidate.side, a = sides.origin(side), c = sides.tip(nextSide(side));
    mesh.vertices[a] = merged(before.vertices[a], before.vertices[c], ground);
    collapsedInto[c] = a;
    isGone[side / 4] = 1;
    joinCurves(mesh, sides, side, nextSide(side));
    joinCurves(mesh, sides, nextSide(nextSide(side)), prevSide(side));
    ++count;
  }
  for (Four<Index>& quad : mesh.quads)
    for (Index& v : quad) v = collapsedInto[v];
  dropQuads(mesh, isGone);
  dropUnusedVertices(mesh);
  return count;
}

}  // namespace

void collapseFlatCorners(QuadMesh& mesh, const WorkingMesh& ground) {
  for (bool isDone = false; !isDone;)
    isDone = collapseOnce(mesh, ground, &QuadCollapses::ofFlatCorners, mesh.vertices.size()) == 0;
}

std::size_t collapseTo(QuadMesh& mesh, const WorkingMesh& ground, const CollapseGoal& goal) {
  if (mesh.vertices.size() <= goal.vertices) return 0;
  const std::size_t runs = (mesh.vertices.size() - goal.vertices - 1) / kLongRun + 1;
  std::size_t all = 0;
  while (mesh.vertices.size() > goal.vertices) {
    const std::size_t most = mesh.vertices.size() - goal.vertices;
    std::size_t gone = collapseOnce(mesh, ground, &QuadCollapses::ofSoundQuads, most, 0);
    if (gone == 0)
      gone = collapseOnce(mesh, ground, &QuadCollapses::ofSoundQuads, std::min(most, runs));
    if (gone == 0 && goal.mayFold) gone = collapseOnce(mesh, ground, &QuadCollapses::ofQuads, 1);
    if (gone == 0) break;
    all += gone;
  }
  return all;
}

}  // namespace remesher
