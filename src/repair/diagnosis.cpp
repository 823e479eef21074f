// SPDX-License-Identifier: MIT
#include "repair/diagnosis.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/disjoint_sets.h"
#include "geometry/triangle.h"
#include "measure/self_intersections.h"
#include "repair/body_mesh.h"
#include "repair/holes/plug.h"
#include "repair/ladder.h"
#include "repair/stitch.h"

namespace remesher {

namespace {

// Where a surface of one side was cut its triangles still meet: such edges bound no opening, and
// what is left of loops that run along them is joined at its ends.
std::vector<Opening> besideSeams(const BuiltMesh& built, const std::vector<Loop>& loops) {
  std::map<std::pair<Index, Index>, std::vector<Halfedge>> edges;  // by places
  for (const Loop& loop : loops)
    for (const Halfedge h : loop.across)
      edges[std::minmax(Index(built.sources[built.mesh.origin(h)]),
                        Index(built.sources[built.mesh.tip(h)]))]
          .push_back(h);
  std::erase_if(edges, [](const auto& edge) { return edge.second.size() > 1; });
  Index count = 0;
  for (const auto& [ends, across] : edges) count = std::max(count, ends.second + 1);
  DisjointSets joined(count);
  for (const auto& [ends, across] : edges) joined.unite(ends.first, ends.second);
  std::map<Index, Opening> openings;
  for (const auto& [ends, across] : edges) {
    const Vec3 &a = built.positions[built.mesh.origin(across.front())],
               &b = built.positions[built.mesh.tip(across.front())];
    Opening& opening = openings[joined.find(ends.first)];
    if (opening.length == 0) opening.at = a;
    opening.length += distance(a, b);
  }
  std::vector<Opening> all;
  for (const auto& [first, opening] : openings) all.push_back(opening);
  return all;
}

}  // namespace

Diagnosis diagnose(const TriangleMesh& mesh) {
  Diagnosis result{buildBodies(mesh), {}, selfIntersections(mesh), countUnbalancedEdges(mesh)};
  std::vector<char> isCrossed(mesh.triangleCount(), 0);
  for (const Index t : result.crossings) isCrossed[t] = 1;
  result.pieces = piecesOf(result.built, isCrossed);
  return result;
}

bool isSound(const Diagnosis& diagnosis) {
  if (diagnosis.unbalanced > 0 || !diagnosis.crossings.empty()) return false;
  const std::vector<SurfacePiece>& pieces = diagnosis.pieces.pieces;
  return std::none_of(pieces.begin(), pieces.end(), [](const SurfacePiece& piece) {
    return isShell(piece) || isInsideOut(piece);
  });
}

double openShare(const Diagnosis& diagnosis) {
  double open = 0, all = 0;
  for (const SurfacePiece& piece : diagnosis.pieces.pieces) {
    all += piece.area;
    if (isSheet(piece)) open += piece.area;
  }
  return all > 0 ? open / all : 0;
}

bool isShell(const SurfacePiece& piece) { return piece.kind == SurfacePiece::Kind::Shell; }
bool isInsideOut(const SurfacePiece& piece) { return piece.isInsideOut; }
bool isCavity(const SurfacePiece& piece) { return piece.kind == SurfacePiece::Kind::Cavity; }
bool isSheet(const SurfacePiece& piece) { return piece.kind == SurfacePiece::Kind::Open; }
bool isCard(const SurfacePiece& piece) { return isSheet(piece) && piece.isFlat && piece.faces > 1; }

std::vector<Vec3> cornersOf(const Diagnosis& diagnosis, bool (*hasFault)(const SurfacePiece&)) {
  const auto& [ofFace, pieces] = diagnosis.pieces;
  std::vector<char> isListed(pieces.size(), 0);
  std::vector<Vec3> corners;
  for (Index f = 0; f < ofFace.size(); ++f) {
    if (isListed[ofFace[f]] || !hasFault(pieces[ofFace[f]])) continue;
    isListed[ofFace[f]] = 1;
    corners.push_back(diagnosis.built.positions[diagnosis.built.mesh.vertices(Face(f))[0]]);
  }
  return corners;
}

std::vector<Index> trianglesOf(const Diagnosis& diagnosis, bool (*hasFault)(const SurfacePiece&)) {
  const auto& [ofFace, pieces] = diagnosis.pieces;
  std::vector<Index> triangles;
  for (Index f = 0; f < ofFace.size(); ++f)
    if (hasFault(pieces[ofFace[f]])) triangles.push_back(diagnosis.built.triangles[Face(f)]);
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<Opening> openingsOf(const BuiltMesh& built) {
  const std::vector<Loop> loops = boundaryLoops(built);
  if (std::any_of(built.warnings.begin(), built.warnings.end(),
                  [](const Warning& warning) { return warning.code == "NON_ORIENTABLE_CUT"; }))
    return besideSeams(built, loops);
  std::vector<Opening> openings;
  for (const Loop& loop : loops)
    openings.push_back({loop.length, built.positions[loop.vertices.front()]});
  return openings;
}

std::vector<Vec3> facingInwards(const Diagnosis& diagnosis) {
  const BuiltMesh& built = diagnosis.built;
  const auto& [ofFace, pieces] = diagnosis.pieces;
  struct Sums {
    std::optional<Vec3> apex;
    double volume = 0, lids = 0;
  };
  std::vector<Sums> sums(pieces.size());
  const auto add = [](Sums& sum, const Vec3& a, const Vec3& b, const Vec3& c) {
    sum.volume += (a - *sum.apex).dot((b - *sum.apex).cross(c - *sum.apex)) / 6;
  };
  for (Index f = 0; f < ofFace.size(); ++f) {
    const auto [a, b, c] = built.mesh.vertices(Face(f));
    Sums& sum = sums[ofFace[f]];
    if (!sum.apex) sum.apex = built.positions[a];
    add(sum, built.positions[a], built.positions[b], built.positions[c]);
  }
  for (const Loop& loop : boundaryLoops(built)) {
    Sums& sum = sums[ofFace[HalfedgeMesh::face(loop.across.front()).index]];
    Vec3 middle = Vec3::Zero();
    for (const Vertex v : loop.vertices)
      middle += built.positions[v] / double(loop.vertices.size());
    for (const Halfedge h : loop.across) {
      const Vec3 &a = built.positions[built.mesh.origin(h)],
                 &b = built.positions[built.mesh.tip(h)];
      add(sum, b, a, middle);
      sum.lids += area(b, a, middle);
    }
  }
  std::vector<Vec3> corners;
  for (std::size_t p = 0; p < pieces.size(); ++p)
    if (isSheet(pieces[p]) && sums[p].volume < 0 &&
        sums[p].lids <= ladder::kMostDisk * pieces[p].area)
      corners.push_back(*sums[p].apex);
  return corners;
}

}  // namespace remesher
