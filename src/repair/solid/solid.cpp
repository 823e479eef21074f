// SPDX-License-Identifier: MIT
#include "repair/solid/solid.h"

#include <algorithm>
#include <span>
#include <utility>

#include "geometry/triangle.h"
#include "mesh/mesh_builder.h"
#include "repair/solid/clean_up.h"
#include "repair/solid/contour.h"
#include "repair/solid/contour_attributes.h"
#include "repair/solid/inside.h"
#include "repair/solid/oriented_patches.h"
#include "repair/solid/outside_flood.h"
#include "repair/solid/thin_walls.h"

namespace remesher {

namespace {

// Per face of the built mesh its three vertices, turned if its patch is.
std::vector<Index> turnedCorners(const BuiltMesh& built, const OrientedPatches& patches) {
  std::vector<Index> corners = built.mesh.triangles();
  for (std::size_t f = 0; f < patches.patches.size(); ++f)
    if (patches.turn[patches.patches[f]]) std::swap(corners[3 * f + 1], corners[3 * f + 2]);
  return corners;
}

std::size_t countTurned(const TriangleMesh& input, const BuiltMesh& built,
                        const OrientedPatches& patches) {
  std::size_t turned = 0;
  for (Index f = 0; f < patches.patches.size(); ++f) {
    const Index* given = &input.indices[3 * std::size_t{built.triangles[Face(f)]}];
    const bool isSwapped = built.wedges[HalfedgeMesh::halfedge(Face(f), 1)] != given[1];
    turned += isSwapped != (patches.turn[patches.patches[f]] != 0);
  }
  return turned;
}

// Both ends of the lattice edges that cross walls of kept cavities.
std::vector<std::size_t> keptPoints(const Lattice& lattice, const OrientedPatches& patches,
                                    std::span<const EdgeCrossing> crossings) {
  std::vector<std::size_t> points;
  for (const EdgeCrossing& c : crossings) {
    const Index patch = patches.patches[c.triangle];
    if (!patches.isCavity[patch] || patches.turn[patch]) continue;
    points.push_back(c.edge / 3);
    points.push_back(c.edge / 3 + lattice.stride(c.edge % 3));
  }
  return points;
}

// Per patch whether the border between inside and outside follows it anywhere.
std::vector<char> onBorder(const Lattice& lattice, const OrientedPatches& patches,
                           std::span<const EdgeCrossing> crossings,
                           const std::vector<char>& isInside) {
  std::vector<char> result(patches.count, 0);
  for (const EdgeCrossing& c : crossings)
    if (isInside[c.edge / 3] != isInside[c.edge / 3 + lattice.stride(c.edge % 3)])
      result[patches.patches[c.triangle]] = 1;
  return result;
}

// Counts closed pieces that are neither seen nor on that border.
std::size_t countShells(const OrientedPatches& patches, const std::vector<char>& isShown) {
  std::size_t shells = 0;
  for (std::size_t p = 0; p < patches.count; ++p)
    shells += patches.isClosed[p] && !patches.isSeen[p] && !isShown[p];
  return shells;
}

std::size_t countSheets(const OrientedPatches& patches, const std::vector<Index>& triangles) {
  std::vector<char> isSheet(patches.count, 0);
  for (const Index triangle : triangles) {
    const Index patch = patches.patches[triangle];
    if (!patches.isClosed[patch]) isSheet[patch] = 1;  // closed ones only graze an edge
  }
  return std::size_t(std::count(isSheet.begin(), isSheet.end(), 1));
}

// Of the area of all triangles that lines of the lattice cross, the share of those with the outside
// on both sides. Where triangles are smaller than cells many are crossed by none.
double shareOfSheets(const BuiltMesh& built, std::span<const EdgeCrossing> crossings,
                     std::span<const Index> sheets) {
  std::vector<char> isCrossed(built.mesh.faceCapacity(), 0), isSheet = isCrossed;
  for (const EdgeCrossing& c : crossings) isCrossed[c.triangle] = 1;
  for (const Index f : sheets) isSheet[f] = 1;
  double all = 0, own = 0;
  for (Index f = 0; f < isCrossed.size(); ++f) {
    if (!isCrossed[f]) continue;
    const auto [a, b, c] = built.mesh.vertices(Face(f));
    const double size = area(built.positions[a], built.positions[b], built.positions[c]);
    all += size;
    if (isSheet[f]) own += size;
  }
  return all > 0 ? own / all : 0;
}

// Seen along the axes: the first and the last crossing of each line. Found again: on or next to an
// edge that the border between inside and outside crosses.
void measureLost(const Lattice& lattice, const InsideField& field,
                 std::span<const EdgeCrossing> crossings, Enclosure& result) {
  std::size_t seen = 0, lost = 0;
  const auto isFound = [&](const EdgeCrossing& c) {
    const std::size_t stride = lattice.stride(c.edge % 3), p = c.edge / 3;
    const bool first = field.isInside[p];
    return field.isInside[p + stride] != first || field.isInside[p - stride] != first ||
           field.isInside[p + 2 * stride] != first;
  };
  forEachCrossedLine(lattice, crossings, [&](const CrossedLine& line) {
    for (const EdgeCrossing* c : {&line.crossings.front(), &line.crossings.back()}) {
      ++seen;
      lost += !isFound(*c);
    }
  });
  result.lost = seen > 0 ? 100 * double(lost) / double(seen) : 0;
}

}  // namespace

struct SolidGround::Known {
  Known(const TriangleMesh& mesh, const SolidRule& how)
      : input(mesh),
        rule(how),
        built(buildMesh(mesh)),
        lattice(mesh, how.spacing, how.gap / 2),
        crossings(crossingsOfEdges(lattice, built.positions.values(), built.mesh.triangles())),
        patches(rule.keepsCavities ? withCavitiesKept(orientedPatches(built, lattice, crossings))
                                   : orientedPatches(built, lattice, crossings)) {
    turnCrossings(crossings, patches);
    divideThinWalls();
    const std::vector<std::size_t> kept = keptPoints(lattice, patches, crossings);
    field = rule.by == InsideBy::Reach ? outsideFlood(lattice, crossings, {rule.gap, rule.sheets})
                                       : insideField(lattice, crossings, kept);
    // Thin walls and sheets may have closed cavities.
    if (keepThinWalls(lattice, crossings, field) || !field.sheets.empty())
      fillCavities(lattice, kept, field.isInside);
  }

  void divideThinWalls() {
    const auto planes = planesInThinWalls(lattice, crossings, patches, rule.mostPoints);
    if (planes[0].empty() && planes[1].empty() && planes[2].empty()) return;
    lattice = lattice.withPlanes(planes);
    crossings = crossingsOfEdges(lattice, built.positions.values(), built.mesh.triangles());
    turnCrossings(crossings, patches);
  }

  const TriangleMesh& input;
  const SolidRule rule;
  const BuiltMesh built;
  Lattice lattice;
  std::vector<EdgeCrossing> crossings;
  const OrientedPatches patches;
  InsideField field;
};

SolidGround::SolidGround(const TriangleMesh& input, const SolidRule& rule)
    : known_(std::make_unique<Known>(input, rule)) {}

SolidGround::~SolidGround() = default;

Enclosure SolidGround::enclosure() const {
  const std::vector<char>& isInside = known_->field.isInside;
  Enclosure result;
  result.turned = countTurned(known_->input, known_->built, known_->patches);
  result.shells = countShells(
      known_->patches, known_->rule.keepsCavities
                           ? onBorder(known_->lattice, known_->patches, known_->crossings, isInside)
                           : std::vector<char>(known_->patches.count, 0));
  result.sheets = countSheets(known_->patches, known_->field.sheets);
  result.sheetShare = shareOfSheets(known_->built, known_->crossings, known_->field.sheets);
  result.unsure = known_->field.unsure;
  measureLost(known_->lattice, known_->field, known_->crossings, result);
  result.isAny = std::find(isInside.begin(), isInside.end(), 1) != isInside.end();
  return result;
}

Solid SolidGround::solid() {
  const TriangleMesh& input = known_->input;
  const BuiltMesh& built = known_->built;
  const std::vector<Index> corners = turnedCorners(built, known_->patches);
  const bool isFinal = known_->rule.cleaning == Cleaning::Thorough;
  const SolidSource source = {built.positions.values(), corners, input.isSingle, input.frame,
                              isFinal ? Ridges::Clear : Ridges::Sharp};
  Contour contour = contourOf(known_->lattice, known_->field, source, known_->crossings);
  const Enclosure enclosed = enclosure();
  if (isFinal)
    contour = cleanedUp(contour, {known_->lattice.spacing(), kindsOf(contour, input, built)});
  return {withAttributes(contour, input, built), enclosed,
          seenLoss(known_->lattice, source, known_->crossings, contour)};
}

}  // namespace remesher
