// SPDX-License-Identifier: MIT
#include "repair/solid/solid.h"

#include <algorithm>
#include <utility>

#include "mesh/mesh_builder.h"
#include "repair/solid/clean_up.h"
#include "repair/solid/contour.h"
#include "repair/solid/contour_attributes.h"
#include "repair/solid/inside.h"
#include "repair/solid/oriented_patches.h"
#include "repair/solid/outside_flood.h"

namespace remesher {

namespace {

// Per face of the built mesh three of its vertices, turned as its patch is.
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

std::vector<char> closedPatches(const BuiltMesh& built, const OrientedPatches& patches) {
  std::vector<char> isClosed(patches.count, 1);
  for (Index h = 0; h < built.mesh.halfedgeCapacity(); ++h)
    if (built.mesh.isBoundary(Halfedge(h))) isClosed[patches.patches[h / 3]] = 0;
  return isClosed;
}

// A piece that is seen faces outwards, as a rule; one that is not seen is the wall of a cavity, and
// faces into it.
void countPieces(const BuiltMesh& built, const OrientedPatches& patches, Enclosure& result) {
  const std::vector<char> isClosed = closedPatches(built, patches);
  for (std::size_t p = 0; p < patches.count; ++p) {
    if (!isClosed[p]) continue;
    result.shells += !patches.isSeen[p];
    result.inner += !patches.isSeen[p] && !patches.turn[p];
    result.insideOut += patches.isSeen[p] && patches.turn[p];
  }
}

// Seen along the axes: the first and the last crossing of each line. Found again: near an edge that
// the border between inside and outside passes.
double lostShare(const Lattice& lattice, const InsideField& field,
                 std::span<const EdgeCrossing> crossings) {
  std::size_t seen = 0, lost = 0;
  const auto isFound = [&](const EdgeCrossing& c) {
    const std::size_t stride = lattice.stride(c.edge % 3), p = c.edge / 3;
    const bool first = field.isInside[p];
    return field.isInside[p + stride] != first || field.isInside[p - stride] != first ||
           field.isInside[p + 2 * stride] != first;
  };
  forEachCrossedLine(lattice, crossings, [&](const CrossedLine& line) {
    for (const EdgeCrossing* c : {&line.crossings.front(), &line.crossings.back()})
      ++seen, lost += !isFound(*c);
  });
  return seen > 0 ? 100 * double(lost) / double(seen) : 0;
}

}  // namespace

struct SolidGround::Known {
  Known(const TriangleMesh& mesh, const SolidRule& how)
      : input(mesh),
        rule(how),
        built(buildMesh(mesh)),
        lattice(mesh, how.spacing, how.gap / 2),
        crossings(crossingsOfEdges(lattice, built.positions.values(), built.mesh.triangles())),
        patches(orientedPatches(built, lattice, crossings)) {
    turnCrossings(crossings, patches);
    field = rule.by == InsideBy::Reach ? outsideFlood(lattice, crossings, rule.gap)
                                       : insideField(lattice, crossings);
    keepThinWalls(lattice, crossings, field);
    fillCavities(lattice, field.isInside);  // which walls so thin may have closed
  }

  const TriangleMesh& input;
  const SolidRule rule;
  const BuiltMesh built;
  const Lattice lattice;
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
  countPieces(known_->built, known_->patches, result);
  result.unsure = known_->field.unsure;
  result.lost = lostShare(known_->lattice, known_->field, known_->crossings);
  result.isAny = std::find(isInside.begin(), isInside.end(), 1) != isInside.end();
  return result;
}

Solid SolidGround::solid() {
  const TriangleMesh& input = known_->input;
  const BuiltMesh& built = known_->built;
  const std::vector<Index> corners = turnedCorners(built, known_->patches);
  Contour contour = contourOf(known_->lattice, known_->field,
                              {built.positions.values(), corners, input.isSingle, input.scale},
                              known_->crossings);
  const Enclosure enclosed = enclosure();
  if (known_->rule.cleaning == Cleaning::Thorough)
    contour = cleanedUp(contour, {known_->lattice.spacing(), kindsOf(contour, input, built)});
  return {withAttributes(contour, input, built), enclosed};
}

}  // namespace remesher
