// SPDX-License-Identifier: MIT
#include "repair/exact_repair.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/fires.h"
#include "base/place.h"
#include "geometry/triangle.h"
#include "measure/self_intersections.h"
#include "mesh/used_vertices.h"
#include "repair/diagnosis.h"
#include "repair/holes/turn_over.h"
#include "repair/ladder.h"
#include "repair/stitch.h"
#include "repair/united.h"

namespace remesher {

namespace {

double areaOf(const TriangleMesh& mesh, std::size_t triangles) {
  double sum = 0;
  for (std::size_t i = 0; i < 3 * triangles; i += 3)
    sum += area(mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                mesh.positions[mesh.indices[i + 2]]);
  return sum;
}

std::size_t countTurned(const TriangleMesh& input, const ClosedHoles& closed) {
  std::size_t turned = 0;
  for (std::size_t i = 0; i < closed.kept.size(); ++i)
    turned +=
        closed.mesh.indices[3 * i + 1] != input.indices[3 * std::size_t{closed.kept[i].index} + 1];
  return turned;
}

ExactRepair withLoopsClosed(const TriangleMesh& input, const LoopRule& rule) {
  ClosedHoles holes = closeHoles(input, rule);
  ExactRepair result;
  result.way = ExactRepair::Way::Closed;
  result.holes = holes.holes;
  result.trianglesRemoved = holes.trianglesRemoved;
  result.openAt = std::move(holes.openAt), result.removedAt = std::move(holes.removedAt);
  result.closedAt = std::move(holes.closedAt), result.meantAt = std::move(holes.meantAt);
  result.rimsAt = std::move(holes.rimsAt);
  result.islands = holes.islands;
  result.sheetsAt = std::move(holes.sheetsAt);
  const double before = areaOf(input, input.triangleCount());
  const double kept = areaOf(holes.mesh, holes.kept.size());
  result.lost = before > 0 ? std::max(0.0, 100 * (1 - kept / before)) : 0;
  result.turned = countTurned(input, holes);
  result.mesh = std::move(holes.mesh);
  return result;
}

// Turns the pieces that are inside out.
void faceOutwards(ExactRepair& repair, const Diagnosis& diagnosis) {
  const std::vector<Index> triangles = trianglesOf(diagnosis, isInsideOut);
  turnOver(repair.mesh, triangles);
  repair.turned += triangles.size();
  repair.way = ExactRepair::Way::Closed;
  if (!repair.mesh.isQuads) return;
  // The halves of a quad change places, so that they are cut from its first corner again.
  for (std::size_t i = 0; i + 1 < triangles.size(); i += 2)
    std::swap_ranges(repair.mesh.indices.begin() + std::ptrdiff_t(3 * triangles[i]),
                     repair.mesh.indices.begin() + std::ptrdiff_t(3 * triangles[i] + 3),
                     repair.mesh.indices.begin() + std::ptrdiff_t(3 * triangles[i + 1]));
}

// Some triangles of a mesh, with their numbers there.
struct Selected {
  TriangleMesh mesh;
  std::vector<Index> triangles;
};

// The triangles that have this mark.
Selected selected(const TriangleMesh& mesh, const std::vector<char>& marks, char mark) {
  Selected part{mesh, {}};
  part.mesh.indices.clear(), part.mesh.groups.clear();
  part.mesh.isQuads = false;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    if (marks[t] != mark) continue;
    const Index* v = &mesh.indices[3 * std::size_t{t}];
    part.mesh.indices.insert(part.mesh.indices.end(), v, v + 3);
    part.triangles.push_back(t);
    if (!mesh.groups.empty()) part.mesh.groups.push_back(mesh.groups[t]);
  }
  return part;
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

// A corner of each closed piece of which nothing is used.
std::vector<Vec3> hiddenAt(const Diagnosis& diagnosis, const std::vector<char>& isUsed) {
  const auto& [ofFace, pieces] = diagnosis.pieces;
  std::vector<char> isListed(pieces.size(), 0);
  for (Index f = 0; f < ofFace.size(); ++f)
    isListed[ofFace[f]] |= pieces[ofFace[f]].kind == SurfacePiece::Kind::Open ||
                           isUsed[diagnosis.built.triangles[Face(f)]];
  std::vector<Vec3> corners;
  for (Index f = 0; f < ofFace.size(); ++f) {
    if (std::exchange(isListed[ofFace[f]], 1)) continue;
    corners.push_back(diagnosis.built.positions[diagnosis.built.mesh.vertices(Face(f))[0]]);
  }
  return corners;
}

// The closed pieces as one outside; false if that is not sound.
bool unite(ExactRepair& repair, const Diagnosis& diagnosis) {
  std::vector<char> isOpen(repair.mesh.triangleCount(), 0);
  if (diagnosis.unbalanced > 0)
    for (const Index t : trianglesOf(diagnosis, isSheet)) isOpen[t] = 1;
  const Selected bodies = selected(repair.mesh, isOpen, 0),
                 sheets = selected(repair.mesh, isOpen, 1);
  std::optional<United> outside = united(bodies.mesh);
  if (!outside || countUnbalancedEdges(outside->mesh) > 0) {
    fires("exact repair: the union is not closed");
    return false;
  }
  if (double(outside->crossings.size()) >
      ladder::kMostCrossingsLeft * double(diagnosis.crossings.size())) {
    fires("exact repair: the union intersects itself");
    return false;
  }
  repair.way = ExactRepair::Way::United;
  std::vector<char> isUsed(repair.mesh.triangleCount(), 0), isWall(isUsed);
  for (const Index t : trianglesOf(diagnosis, isCavity)) isWall[t] = 1;
  for (const Index parent : outside->parents) {
    isUsed[bodies.triangles[parent]] = 1;
    repair.isOfCavity.push_back(isWall[bodies.triangles[parent]]);
  }
  repair.hiddenAt = hiddenAt(diagnosis, isUsed);
  repair.mesh = std::move(outside->mesh);
  repair.crossings = std::move(outside->crossings);
  if (sheets.triangles.empty()) return true;
  append(repair.mesh, sheets.mesh);
  repair.isOfCavity.resize(repair.mesh.triangleCount(), 0);
  keepUsedVertices(repair.mesh);
  repair.crossings = selfIntersections(repair.mesh);
  return true;
}

// Open pieces become bodies.
void makeBodies(ExactRepair& repair, const BodyRule& rule) {
  SheetBodies bodies = bodiesOfSheets(repair.mesh, rule);
  repair.madeAt = std::move(bodies.madeAt);
  repair.noBaseAt = std::move(bodies.leftAt);
  repair.sheetsAt = repair.noBaseAt;
  repair.rimsAt.clear(), repair.openAt.clear();
  if (repair.madeAt.empty()) return;
  repair.mesh = std::move(bodies.mesh);
  keepUsedVertices(repair.mesh);
  if (countUnbalancedEdges(repair.mesh) > 0) stitchOpenEdges(repair.mesh);
}

}  // namespace

TriangleMesh atOnePosition(const TriangleMesh& input) {
  TriangleMesh mesh = input;
  const std::vector<Index> first = weld(input.positions);
  for (const Index v : input.indices)
    if (mesh.positions[v] != input.positions[first[v]])
      mesh.positions[v] = input.positions[first[v]];
  return mesh;
}

ExactRepair closedOnly(const TriangleMesh& input, const LoopRule& rule) {
  ExactRepair result;
  result.mesh = atOnePosition(input);
  Diagnosis diagnosis = diagnose(result.mesh);
  const std::size_t before = diagnosis.crossings.size();
  if (diagnosis.unbalanced > 0) {
    result = withLoopsClosed(result.mesh, rule);
    diagnosis = diagnose(result.mesh);
  }
  if (!trianglesOf(diagnosis, isInsideOut).empty()) faceOutwards(result, diagnosis);
  if (result.way != ExactRepair::Way::Unchanged) keepUsedVertices(result.mesh);
  result.crossingsBefore = before;
  result.crossings = std::move(diagnosis.crossings);
  return result;
}

std::optional<ExactRepair> exactlyRepaired(const TriangleMesh& input, const ExactRule& rule) {
  ExactRepair result;
  result.mesh = atOnePosition(input);
  Diagnosis diagnosis = diagnose(result.mesh);
  const std::size_t before = diagnosis.crossings.size();
  if (isSound(diagnosis)) return result;
  // A triangle without area that closes a T-junction joins nothing once triangles are cut.
  const bool hasLines = !haveAreas(result.mesh);
  if (diagnosis.unbalanced > 0) weldOpenVertices(result.mesh);
  if (diagnosis.unbalanced > 0 || hasLines) {
    stitchOpenEdges(result.mesh);
    if (result.mesh.indices.empty()) {
      fires("exact repair: no triangle has an area");
      return std::nullopt;
    }
    result.way = ExactRepair::Way::Closed;
    if (countUnbalancedEdges(result.mesh) > 0) result = withLoopsClosed(result.mesh, rule.loops);
    if (rule.bodies) makeBodies(result, *rule.bodies);
    diagnosis = diagnose(result.mesh);
  }
  if (!result.sheetsAt.empty() && openShare(diagnosis) > ladder::kMostSheets) {
    fires("exact repair: too much is open");
    return std::nullopt;
  }
  faceOutwards(result, diagnosis);
  const bool hasShells = !cornersOf(diagnosis, isShell).empty();
  result.crossings = diagnosis.crossings;
  if ((!diagnosis.crossings.empty() || hasShells) && !unite(result, diagnosis)) return std::nullopt;
  keepUsedVertices(result.mesh);
  if (!result.madeAt.empty()) result.way = ExactRepair::Way::Made;
  result.crossingsBefore = before;
  return result;
}

ExactRepair leftAlone(const TriangleMesh& input) {
  ExactRepair result;
  result.mesh = input;
  const Diagnosis diagnosis = diagnose(input);
  result.sheetsAt = cornersOf(diagnosis, isSheet);
  result.crossingsBefore = diagnosis.crossings.size();
  result.crossings = diagnosis.crossings;
  return result;
}

void fillCavities(ExactRepair& repair, Filled filled) {
  if (filled == Filled::Made && repair.isOfCavity.empty()) return;
  const BuiltMesh built = buildMesh(repair.mesh);
  const std::vector<char> isCrossed(repair.mesh.triangleCount(), 0);
  const auto [ofFace, pieces] = piecesOf(built, isCrossed);
  std::vector<char> isFilled(pieces.size(), 0), isWall(repair.mesh.triangleCount(), 0);
  for (std::size_t p = 0; p < pieces.size(); ++p) isFilled[p] = isCavity(pieces[p]);
  for (Index f = 0; f < ofFace.size() && filled == Filled::Made; ++f)
    if (repair.isOfCavity[built.triangles[Face(f)]]) isFilled[ofFace[f]] = 0;
  std::vector<char> isListed(pieces.size(), 0);
  for (Index f = 0; f < ofFace.size(); ++f) {
    if (!isFilled[ofFace[f]]) continue;
    isWall[built.triangles[Face(f)]] = 1;
    if (!std::exchange(isListed[ofFace[f]], 1))
      repair.filledAt.push_back(built.positions[built.mesh.vertices(Face(f))[0]]);
  }
  if (repair.filledAt.empty()) return;
  repair.mesh = selected(repair.mesh, isWall, 0).mesh;
  keepUsedVertices(repair.mesh);
  repair.way = ExactRepair::Way::United;
  if (!repair.crossings.empty()) repair.crossings = selfIntersections(repair.mesh);
}

}  // namespace remesher
