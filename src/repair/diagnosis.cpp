// SPDX-License-Identifier: MIT
#include "repair/diagnosis.h"

#include <algorithm>

#include "measure/self_intersections.h"
#include "repair/body_mesh.h"
#include "repair/stitch.h"

namespace remesher {

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

}  // namespace remesher
