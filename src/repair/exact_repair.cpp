// SPDX-License-Identifier: MIT
#include "repair/exact_repair.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/place.h"
#include "geometry/triangle.h"
#include "measure/self_intersections.h"
#include "repair/diagnosis.h"
#include "repair/holes/turn_over.h"
#include "repair/holes/used_vertices.h"
#include "repair/stitch.h"
#include "repair/united.h"

namespace remesher {

namespace {

// A surface with more of its area in sheets than this is not repaired exactly.
constexpr double kMostSheets = 0.3;
// Rounding may leave this share of the self-intersections that there were.
constexpr double kMostCrossingsLeft = 0.05;

double areaOf(const TriangleMesh& mesh, std::size_t triangles) {
  double sum = 0;
  for (std::size_t i = 0; i < 3 * triangles; i += 3)
    sum += area(mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                mesh.positions[mesh.indices[i + 2]]);
  return sum;
}

// Vertices that count as one get the same coordinates, so that every reader finds them to be one.
TriangleMesh atOnePosition(const TriangleMesh& input) {
  TriangleMesh mesh = input;
  const std::vector<Index> first = weld(input.positions);
  for (const Index v : input.indices)
    if (mesh.positions[v] != input.positions[first[v]])
      mesh.positions[v] = input.positions[first[v]];
  return mesh;
}

std::size_t countTurned(const TriangleMesh& input, const ClosedHoles& closed) {
  std::size_t turned = 0;
  for (std::size_t i = 0; i < closed.kept.size(); ++i)
    turned +=
        closed.mesh.indices[3 * i + 1] != input.indices[3 * std::size_t{closed.kept[i].index} + 1];
  return turned;
}

// Triangles of a piece that is inside out are turned. Those of quads change places with their
// halves, so that each pair is cut from its quad's first corner again.
void turnOutwards(TriangleMesh& mesh, const std::vector<Index>& triangles) {
  turnOver(mesh, triangles);
  if (!mesh.isQuads) return;
  for (std::size_t i = 0; i + 1 < triangles.size(); i += 2)
    std::swap_ranges(mesh.indices.begin() + std::ptrdiff_t(3 * triangles[i]),
                     mesh.indices.begin() + std::ptrdiff_t(3 * triangles[i] + 3),
                     mesh.indices.begin() + std::ptrdiff_t(3 * triangles[i + 1]));
}

ExactRepair closed(const TriangleMesh& input, const LoopRule& rule) {
  ClosedHoles holes = closeHoles(input, rule);
  ExactRepair result;
  result.way = ExactRepair::Way::Closed;
  result.holes = holes.holes;
  result.trianglesRemoved = holes.trianglesRemoved;
  result.openAt = std::move(holes.openAt), result.removedAt = std::move(holes.removedAt);
  result.islands = holes.islands;
  result.sheetsAt = std::move(holes.sheetsAt);
  const double before = areaOf(input, input.triangleCount());
  const double kept = areaOf(holes.mesh, holes.kept.size());
  result.lost = before > 0 ? std::max(0.0, 100 * (1 - kept / before)) : 0;
  turnOutwards(holes.mesh, trianglesOf(diagnose(holes.mesh), isInsideOut));
  result.turned = countTurned(input, holes);
  result.mesh = std::move(holes.mesh);
  return result;
}

// The triangles of closed pieces, and those of open ones.
std::array<TriangleMesh, 2> parted(const TriangleMesh& mesh, const Diagnosis& diagnosis) {
  std::vector<char> isOpen(mesh.triangleCount(), 0);
  for (const Index t :
       trianglesOf(diagnosis, [](const Piece& piece) { return piece.kind == Piece::Kind::Open; }))
    isOpen[t] = 1;
  std::array<TriangleMesh, 2> parts = {mesh, mesh};
  for (TriangleMesh& part : parts) {
    part.indices.clear(), part.groups.clear();
    part.isQuads = false;
  }
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    TriangleMesh& part = parts[std::size_t(isOpen[t])];
    const Index* v = &mesh.indices[3 * std::size_t{t}];
    part.indices.insert(part.indices.end(), v, v + 3);
    if (!mesh.groups.empty()) part.groups.push_back(mesh.groups[t]);
  }
  return parts;
}

void append(TriangleMesh& mesh, const TriangleMesh& more) {
  const Index offset = Index(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  for (const Index v : more.indices) mesh.indices.push_back(v + offset);
  mesh.groups.insert(mesh.groups.end(), more.groups.begin(), more.groups.end());
  for (std::size_t a = 0; a < mesh.attributes.size(); ++a)
    mesh.attributes[a].values.insert(mesh.attributes[a].values.end(),
                                     more.attributes[a].values.begin(),
                                     more.attributes[a].values.end());
}

// A corner of each closed piece of which nothing is used. bodies: the triangles of closed pieces.
std::vector<Vec3> hiddenAt(const TriangleMesh& bodies, const United& outside) {
  const Diagnosis pieces = diagnose(bodies);
  const auto& ofFace = pieces.pieces.ofFace;
  std::vector<char> isUsed(pieces.pieces.pieces.size(), 0), isListed(isUsed.size(), 0);
  for (Index f = 0; f < ofFace.size(); ++f)
    if (outside.isUsed[pieces.built.triangles[Face(f)]]) isUsed[ofFace[f]] = 1;
  std::vector<Vec3> corners;
  for (Index f = 0; f < ofFace.size(); ++f) {
    if (isUsed[ofFace[f]] || isListed[ofFace[f]]) continue;
    isListed[ofFace[f]] = 1;
    corners.push_back(pieces.built.positions[pieces.built.mesh.vertices(Face(f))[0]]);
  }
  return corners;
}

// The closed pieces as one outside; false if that is not sound.
bool unite(ExactRepair& repair, const Diagnosis& diagnosis) {
  const auto [bodies, sheets] = parted(repair.mesh, diagnosis);
  std::optional<United> outside = united(bodies);
  if (!outside || countUnbalancedEdges(outside->mesh) > 0) return false;
  if (double(outside->selfIntersections) > kMostCrossingsLeft * double(diagnosis.crossings.size()))
    return false;
  repair.way = ExactRepair::Way::United;
  repair.hiddenAt = hiddenAt(bodies, *outside);
  repair.mesh = std::move(outside->mesh);
  append(repair.mesh, sheets);
  keepUsedVertices(repair.mesh);
  repair.crossings = selfIntersections(repair.mesh);
  return true;
}

}  // namespace

ExactRepair closedOnly(const TriangleMesh& input, const LoopRule& rule) {
  const TriangleMesh mesh = atOnePosition(input);
  ExactRepair result;
  result.mesh = mesh;
  if (isSound(diagnose(mesh))) return result;
  result = closed(mesh, rule);
  keepUsedVertices(result.mesh);
  result.crossings = selfIntersections(result.mesh);
  return result;
}

std::optional<ExactRepair> exactlyRepaired(const TriangleMesh& input, const LoopRule& rule) {
  ExactRepair result;
  result.mesh = atOnePosition(input);
  const Diagnosis given = diagnose(result.mesh);
  if (isSound(given)) return result;
  if (given.unbalanced > 0) {
    weldOpenVertices(result.mesh);
    stitchOpenEdges(result.mesh);
    if (result.mesh.indices.empty()) return std::nullopt;
  }
  result = closed(result.mesh, rule);
  const Diagnosis diagnosis = diagnose(result.mesh);
  if (!result.sheetsAt.empty() && openShare(diagnosis) > kMostSheets) return std::nullopt;
  const bool hasShells = !cornersOf(diagnosis, isShell).empty();
  if (diagnosis.crossings.empty() && !hasShells) {
    keepUsedVertices(result.mesh);
    return result;
  }
  if (!unite(result, diagnosis)) return std::nullopt;
  return result;
}

ExactRepair leftAlone(const TriangleMesh& input) {
  ExactRepair result;
  result.mesh = input;
  const Diagnosis diagnosis = diagnose(input);
  result.sheetsAt =
      cornersOf(diagnosis, [](const Piece& piece) { return piece.kind == Piece::Kind::Open; });
  result.crossings = diagnosis.crossings;
  return result;
}

void fillCavities(ExactRepair& repair) {
  const Diagnosis diagnosis = diagnose(repair.mesh);
  const auto isCavity = [](const Piece& piece) { return piece.kind == Piece::Kind::Cavity; };
  const std::vector<Index> walls = trianglesOf(diagnosis, isCavity);
  repair.filledAt = cornersOf(diagnosis, isCavity);
  if (walls.empty()) return;
  std::vector<char> isWall(repair.mesh.triangleCount(), 0);
  for (const Index t : walls) isWall[t] = 1;
  TriangleMesh& mesh = repair.mesh;
  std::vector<Index> indices, groups;
  for (Index t = 0; t < isWall.size(); ++t) {
    if (isWall[t]) continue;
    indices.insert(indices.end(), &mesh.indices[3 * std::size_t{t}],
                   &mesh.indices[3 * std::size_t{t}] + 3);
    if (!mesh.groups.empty()) groups.push_back(mesh.groups[t]);
  }
  mesh.indices = std::move(indices), mesh.groups = std::move(groups);
  keepUsedVertices(mesh);
}

}  // namespace remesher
