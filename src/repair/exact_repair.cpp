// SPDX-License-Identifier: MIT
#include "repair/exact_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/fires.h"
#include "base/place.h"
#include "geometry/mesh_triangle.h"
#include "geometry/triangle.h"
#include "measure/self_intersections.h"
#include "mesh/used_vertices.h"
#include "repair/body_mesh.h"
#include "repair/body_union.h"
#include "repair/diagnosis.h"
#include "repair/holes/turn_over.h"
#include "repair/ladder.h"
#include "repair/loose_pieces.h"
#include "repair/one_sided.h"
#include "repair/stitch.h"
#include "repair/united.h"

namespace remesher {

namespace {

// Of the first triangles; those given twice count once.
double areaOf(const TriangleMesh& mesh, std::size_t triangles) {
  const std::vector<Index> first = weld(mesh.positions);
  std::vector<std::array<Index, 4>> places;  // three sorted, and the triangle
  for (Index t = 0; t < triangles; ++t) {
    const Index* v = &mesh.indices[3 * std::size_t{t}];
    std::array<Index, 4> own = {first[v[0]], first[v[1]], first[v[2]], t};
    std::sort(own.begin(), own.begin() + 3);
    places.push_back(own);
  }
  std::sort(places.begin(), places.end());
  double sum = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto [a, b, c, triangle] = places[i];
    const bool isRepeated =
        i > 0 && std::equal(places[i].begin(), places[i].begin() + 3, places[i - 1].begin());
    if (!isRepeated) sum += area(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
  }
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
  result.lines = holes.lines;
  result.openAt = std::move(holes.openAt), result.removedAt = std::move(holes.removedAt);
  result.closedAt = std::move(holes.closedAt), result.meantAt = std::move(holes.meantAt);
  result.rimsAt = std::move(holes.rimsAt);
  result.islands = holes.islands;
  result.sheetsAt = std::move(holes.sheetsAt);
  const double before = areaOf(input, input.triangleCount());
  const double kept = areaOf(holes.mesh, holes.kept.size());
  result.lost = before > 0 ? std::max(0.0, 100 * (1 - kept / before)) : 0;
  result.turned = countTurned(input, holes);
  result.lids = holes.mesh.triangleCount() - holes.kept.size();
  result.mesh = std::move(holes.mesh);
  return result;
}

// The halves of quads that were turned change places, so that they are cut from their first corners
// again.
void swapHalves(TriangleMesh& mesh, const std::vector<Index>& triangles) {
  for (std::size_t i = 0; i + 1 < triangles.size(); i += 2)
    std::swap_ranges(mesh.indices.begin() + std::ptrdiff_t(3 * triangles[i]),
                     mesh.indices.begin() + std::ptrdiff_t(3 * triangles[i] + 3),
                     mesh.indices.begin() + std::ptrdiff_t(3 * triangles[i + 1]));
}

// Together with those that repeat one of them: only the first of these is a face of a piece.
std::vector<Index> withRepeated(const TriangleMesh& mesh, const BuiltMesh& built,
                                std::vector<Index> triangles) {
  if (triangles.empty() || built.triangles.size() == mesh.triangleCount()) return triangles;
  const std::vector<Index> first = weld(mesh.positions);
  const auto keyOf = [&](Index t) {
    std::array<Index, 3> key{};
    for (std::size_t k = 0; k < 3; ++k) key[k] = first[mesh.indices[3 * std::size_t{t} + k]];
    std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
    return key;
  };
  std::vector<std::array<Index, 3>> keys;
  for (const Index t : triangles) keys.push_back(keyOf(t));
  std::sort(keys.begin(), keys.end());
  std::vector<char> isFace(mesh.triangleCount(), 0);
  for (const Index t : built.triangles.values()) isFace[t] = 1;
  for (Index t = 0; t < isFace.size(); ++t)
    if (!isFace[t] && std::binary_search(keys.begin(), keys.end(), keyOf(t)))
      triangles.push_back(t);
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

// Turns the pieces that are inside out. Returns their triangles, ascending.
std::vector<Index> turnPieces(TriangleMesh& mesh, const Diagnosis& diagnosis) {
  const std::vector<Index> triangles =
      withRepeated(mesh, diagnosis.built, trianglesOf(diagnosis, isInsideOut));
  turnOver(mesh, triangles);
  if (mesh.isQuads) swapHalves(mesh, triangles);
  return triangles;
}

// Lids were not given, so that none of them counts as turned.
void faceOutwards(ExactRepair& repair, const Diagnosis& diagnosis) {
  const std::vector<Index> turned = turnPieces(repair.mesh, diagnosis);
  const Index firstLid = Index(repair.mesh.triangleCount() - repair.lids);
  repair.turned +=
      std::size_t(std::lower_bound(turned.begin(), turned.end(), firstLid) - turned.begin());
  repair.way = ExactRepair::Way::Closed;
}

// Whether a closed piece is triangles back to back, such as the common walls of bodies that touch.
bool enclosesNothing(const SurfacePiece& piece) {
  constexpr double kRounding = 1e-12;
  const double diagonal = (piece.box.high - piece.box.low).norm();
  return std::abs(piece.volume) <= kRounding * piece.area * diagonal;
}

// Of the closed pieces of which nothing is used, a corner of each body and how large it is, and how
// many triangles enclose none.
void noteHidden(ExactRepair& repair, const Diagnosis& diagnosis, const std::vector<char>& isUsed) {
  const auto& [ofFace, pieces] = diagnosis.pieces;
  std::vector<char> isListed(pieces.size(), 0);
  for (Index f = 0; f < ofFace.size(); ++f)
    isListed[ofFace[f]] |= pieces[ofFace[f]].kind == SurfacePiece::Kind::Open ||
                           isUsed[diagnosis.built.triangles[Face(f)]];
  for (Index f = 0; f < ofFace.size(); ++f) {
    if (std::exchange(isListed[ofFace[f]], 1)) continue;
    const SurfacePiece& piece = pieces[ofFace[f]];
    if (enclosesNothing(piece))
      repair.backToBack += piece.faces;
    else
      repair.hiddenAt.push_back(
          {diagnosis.built.positions[diagnosis.built.mesh.vertices(Face(f))[0]],
           (piece.box.high - piece.box.low).norm()});
  }
}

// Sets triangles aside for another way of repair.
void leaveUndecided(ExactRepair& repair, SelectedTriangles triangles) {
  keepUsedVertices(triangles.mesh);
  if (repair.undecided.indices.empty())
    repair.undecided = std::move(triangles.mesh);
  else
    append(repair.undecided, triangles.mesh);
}

// Per triangle 1 if its number is in the list, else 0.
std::vector<Index> markedOf(const TriangleMesh& mesh, const std::vector<Index>& triangles) {
  std::vector<Index> marks(mesh.triangleCount(), 0);
  for (const Index t : triangles) marks[t] = 1;
  return marks;
}

// Per triangle whether it bounds a cavity. The inner wall of an open double shell bounds none: it
// was seen through its loop, and the lid is a good part of it.
std::vector<char> wallsOfCavities(const ExactRepair& repair, const Diagnosis& diagnosis) {
  const auto& [ofFace, pieces] = diagnosis.pieces;
  const std::vector<Index>& triangles = diagnosis.built.triangles.values();
  const std::size_t count = repair.mesh.triangleCount();
  std::vector<double> lids(pieces.size(), 0);
  for (Index f = 0; f < ofFace.size(); ++f) {
    const auto [a, b, c] = cornersOf(repair.mesh, triangles[f]);
    if (triangles[f] + repair.lids >= count) lids[ofFace[f]] += area(a, b, c);
  }
  std::vector<char> isWall(count, 0);
  for (Index f = 0; f < ofFace.size(); ++f) {
    const SurfacePiece& piece = pieces[ofFace[f]];
    isWall[triangles[f]] =
        isCavity(piece) && lids[ofFace[f]] <= ladder::kMostDiskOfBody * piece.area;
  }
  return isWall;
}

// The closed pieces as one outside; false if none of them has a sound one.
bool unite(ExactRepair& repair, const Diagnosis& diagnosis) {
  std::vector<Index> open;
  if (diagnosis.unbalanced > 0) open = trianglesOf(diagnosis, isSheet);
  const std::vector<Index> isOpen = markedOf(repair.mesh, open);
  const SelectedTriangles bodies = selected(repair.mesh, isOpen, 0),
                          sheets = selected(repair.mesh, isOpen, 1);
  std::optional<BodyUnion> outside =
      unionOf(bodies.mesh, numbersAmong(bodies.triangles, diagnosis.crossings));
  if (!outside) return false;
  repair.way = ExactRepair::Way::United;
  std::vector<char> isUsed(repair.mesh.triangleCount(), 0);
  const std::vector<char> isWall = wallsOfCavities(repair, diagnosis);
  for (const Index parent : outside->parents) {
    isUsed[bodies.triangles[parent]] = 1;
    repair.isOfCavity.push_back(isWall[bodies.triangles[parent]]);
  }
  for (const Index t : outside->undecided) isUsed[bodies.triangles[t]] = 1;
  noteHidden(repair, diagnosis, isUsed);
  if (!outside->undecided.empty()) {
    leaveUndecided(repair, selected(bodies.mesh, markedOf(bodies.mesh, outside->undecided), 1));
  }
  repair.lost += 100 * outside->lost;
  repair.mesh = std::move(outside->mesh);
  repair.crossings = std::move(outside->crossings);
  if (sheets.triangles.empty()) return true;
  append(repair.mesh, sheets.mesh);
  repair.isOfCavity.resize(repair.mesh.triangleCount(), 0);
  keepUsedVertices(repair.mesh);
  repair.crossings = selfIntersections(repair.mesh);
  return true;
}

// Sets the sheets aside; false if there is nothing else.
bool keepBodies(ExactRepair& repair, const Diagnosis& diagnosis) {
  const std::vector<Index> isOpen = markedOf(repair.mesh, trianglesOf(diagnosis, isSheet));
  SelectedTriangles bodies = selected(repair.mesh, isOpen, 0);
  if (bodies.triangles.empty()) return false;
  leaveUndecided(repair, selected(repair.mesh, isOpen, 1));
  repair.mesh = std::move(bodies.mesh);
  repair.sheetsAt.clear();
  return true;
}

// Triangles without an area are left out of a sound surface, if it stays sound without them. Of
// quads they are halves, as at a pole.
ExactRepair withoutLines(ExactRepair sound) {
  if (haveAreas(sound.mesh) || sound.mesh.isQuads) return sound;
  ExactRepair result = sound;
  stitchOpenEdges(result.mesh);
  if (result.mesh.indices.empty() || !isSound(diagnose(result.mesh))) return sound;
  keepUsedVertices(result.mesh);
  result.way = ExactRepair::Way::Closed;
  return result;
}

// Closes cracks and T-junctions: exactly, or as wide as closes nearly all.
void closeCracks(TriangleMesh& mesh, bool isOpen) {
  TriangleMesh wide;
  if (isOpen) {
    wide = mesh;
    weldOpenVertices(mesh);
  }
  stitchOpenEdges(mesh);
  if (isOpen && countUnbalancedEdges(mesh) > 0 && closeWideCracks(wide)) mesh = std::move(wide);
}

// Open pieces become bodies.
void makeBodies(ExactRepair& repair, const BodyRule& rule) {
  SheetBodies bodies = bodiesOfSheets(repair.mesh, rule);
  repair.madeAt = std::move(bodies.madeAt);
  repair.noBaseAt = std::move(bodies.leftAt);
  repair.sheetsAt = repair.noBaseAt;
  repair.rimsAt.clear(), repair.openAt.clear();
  if (repair.madeAt.empty()) return;
  repair.lids = 0;
  repair.mesh = std::move(bodies.mesh);
  keepUsedVertices(repair.mesh);
  if (countUnbalancedEdges(repair.mesh) > 0) stitchOpenEdges(repair.mesh);
}

// Parts with one side only become bodies before anything is cut at their seams. A scan that is torn
// at so few of its edges is cut open and closed there, as are its holes.
std::vector<SizedPlace> makeBodiesOfOneSided(ExactRepair& repair, const ExactRule& rule) {
  if (!rule.bodies || rule.bodies->kind != BodyRule::Kind::Thick) return {};
  constexpr std::size_t kTorn = 1000;  // triangles for the square of these edges
  const OneSided found = oneSidedOf(repair.mesh);
  if (kTorn * found.edges * found.edges < found.triangles.size() || found.edges == 0) return {};
  const std::vector<Index> marks = markedOf(repair.mesh, found.triangles);
  SheetBodies bodies =
      bodiesOfOneSided(selected(repair.mesh, marks, 1).mesh, rule.bodies->thickness);
  repair.mesh = selected(repair.mesh, marks, 0).mesh;
  append(repair.mesh, bodies.mesh);
  keepUsedVertices(repair.mesh);
  return std::move(bodies.madeAt);
}

// The pieces of a surface that does not intersect itself.
struct BodyPieces {
  explicit BodyPieces(const TriangleMesh& mesh)
      : built(buildBodies(mesh)),
        pieces(piecesOf(built, std::vector<char>(mesh.triangleCount(), 0))) {}
  BuiltMesh built;
  Pieces pieces;
};

std::vector<char> marked(const std::vector<SurfacePiece>& pieces,
                         bool (*isWanted)(const SurfacePiece&)) {
  std::vector<char> marks;
  for (const SurfacePiece& piece : pieces) marks.push_back(isWanted(piece));
  return marks;
}

// Takes those pieces out of the mesh; returns a corner of each, and how large it is.
std::vector<SizedPlace> leaveOut(TriangleMesh& mesh, const BodyPieces& all,
                                 const std::vector<char>& isUnwanted) {
  const auto& [ofFace, pieces] = all.pieces;
  std::vector<SizedPlace> found;
  std::vector<char> isListed(pieces.size(), 0);
  std::vector<Index> marks(mesh.triangleCount(), 0);
  for (Index f = 0; f < ofFace.size(); ++f) {
    if (!isUnwanted[ofFace[f]]) continue;
    marks[all.built.triangles[Face(f)]] = 1;
    if (std::exchange(isListed[ofFace[f]], 1)) continue;
    const Box& box = pieces[ofFace[f]].box;
    found.push_back(
        {all.built.positions[all.built.mesh.vertices(Face(f))[0]], (box.high - box.low).norm()});
  }
  if (found.empty()) return found;
  mesh = selected(mesh, marks, 0).mesh;
  keepUsedVertices(mesh);
  return found;
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
  if (isSound(diagnosis)) return withoutLines(std::move(result));
  const std::vector<SizedPlace> ofOneSided = makeBodiesOfOneSided(result, rule);
  if (!ofOneSided.empty()) diagnosis = diagnose(result.mesh);
  // A triangle without area that closes a T-junction joins nothing once triangles are cut.
  const bool hasLines = !haveAreas(result.mesh);
  if (diagnosis.unbalanced > 0 || hasLines) {
    closeCracks(result.mesh, diagnosis.unbalanced > 0);
    if (result.mesh.indices.empty()) {
      fires("exact repair: no triangle has an area");
      return std::nullopt;
    }
    result.way = ExactRepair::Way::Closed;
    if (countUnbalancedEdges(result.mesh) > 0) result = withLoopsClosed(result.mesh, rule.loops);
    if (result.lost > ladder::kMostRemoved) {
      fires("exact repair: too much would be removed");
      return std::nullopt;
    }
    // A disk over a straight loop has no area, either.
    if (!haveAreas(result.mesh)) stitchOpenEdges(result.mesh), result.lids = 0;
    if (rule.bodies) makeBodies(result, *rule.bodies);
    diagnosis = diagnose(result.mesh);
  }
  result.madeAt.insert(result.madeAt.end(), ofOneSided.begin(), ofOneSided.end());
  if (!result.sheetsAt.empty() && openShare(diagnosis) > ladder::kMostSheets) {
    fires("exact repair: too much is open");
    if (!keepBodies(result, diagnosis)) return std::nullopt;
    diagnosis = diagnose(result.mesh);
  }
  faceOutwards(result, diagnosis);
  const bool hasShells = !cornersOf(diagnosis, isShell).empty();
  result.crossings = diagnosis.crossings;
  if (!diagnosis.crossings.empty() || hasShells) {
    if (!unite(result, diagnosis)) return std::nullopt;
  } else if (result.lids > 0) {
    result.isOfCavity = wallsOfCavities(result, diagnosis);
  }
  keepUsedVertices(result.mesh);
  if (!result.madeAt.empty()) result.way = ExactRepair::Way::Made;
  result.crossingsBefore = before;
  return result;
}

bool faceOutwards(TriangleMesh& mesh) {
  const BuiltMesh built = buildBodies(mesh);
  const std::vector<char> isCrossed(mesh.triangleCount(), 0);
  const std::vector<SurfacePiece> pieces = piecesOf(built, isCrossed).pieces;
  if (std::none_of(pieces.begin(), pieces.end(), isInsideOut)) return false;
  return !turnPieces(mesh, diagnose(mesh)).empty();
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
  if (LoosePieces(repair.mesh.positions, repair.mesh.indices).all().size() < 2) return;
  const BodyPieces all(repair.mesh);
  const auto& [ofFace, pieces] = all.pieces;
  std::vector<char> isFilled = marked(pieces, isCavity);
  for (Index f = 0; f < ofFace.size() && filled == Filled::Made; ++f)
    if (repair.isOfCavity[all.built.triangles[Face(f)]]) isFilled[ofFace[f]] = 0;
  const std::vector<SizedPlace> filledAt = leaveOut(repair.mesh, all, isFilled);
  if (filledAt.empty()) return;
  for (const SizedPlace& place : filledAt) repair.filledAt.push_back(place.at);
  // What lay in them is inside of solids now.
  const BodyPieces left(repair.mesh);
  const std::vector<SizedPlace> hidden =
      leaveOut(repair.mesh, left, marked(left.pieces.pieces, isShell));
  repair.hiddenAt.insert(repair.hiddenAt.end(), hidden.begin(), hidden.end());
  repair.way = ExactRepair::Way::United;
  if (!repair.crossings.empty()) repair.crossings = selfIntersections(repair.mesh);
}

}  // namespace remesher
