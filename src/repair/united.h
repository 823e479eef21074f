// SPDX-License-Identifier: MIT
// Closed bodies arranged exactly: where they intersect each other or themselves, their triangles
// are cut along each other and only the boundary of the inside is kept. All other triangles stay as
// they are, bit for bit.
#pragma once

#include <compare>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "arrangement/facets.h"
#include "base/triangle_mesh.h"

namespace remesher {

struct United {
  TriangleMesh mesh;             // without triangles where nothing is inside
  std::vector<Index> parents;    // per triangle of the mesh that of the bodies in whose plane it is
  std::vector<Index> crossings;  // triangles of the mesh that rounding left intersecting others
  double lost = 0;               // see BodyUnion
  std::size_t cut = 0;           // triangles of the bodies that met others
  bool isOutsideDropped = true;  // whether parts went that have no inside on either side
};

// Which operand each triangle of the bodies belongs to, and whether a place is inside by the
// winding number of each operand there.
struct Operands {
  std::vector<Index> numbers;
  std::function<bool(std::span<const int>)> isInside;
  KnownMeetings known;
};

// Of the wanted triangles those in a list, by their places there. Both ascend.
std::vector<Index> numbersAmong(std::span<const Index> list, std::span<const Index> wanted);

// The boundary of the inside. bodies: closed, facing outwards; triangles without an area are left
// out. None if the triangles do not bound volumes, or if the work would be out of proportion.
std::optional<United> arranged(const TriangleMesh& bodies, const Operands& operands);

// What keeps a surface from being sound, the worst first.
struct Defects {
  std::size_t unbalanced = 0;  // edges, see countUnbalancedEdges
  std::size_t crossings = 0;   // triangles that intersect others
  std::size_t touches = 0;     // edges and vertices in which the surface touches itself
  auto operator<=>(const Defects&) const = default;
};
Defects defectsOf(const United& outside);

// The space that counts as inside: with positive winding numbers, or with any but 0.
enum class Inside { Outwards, EitherWay };

// The outside of the bodies, all of one operand. None as above, and if nothing is inside.
// crossings: the triangles that meet others, ascending.
std::optional<United> united(const TriangleMesh& bodies, std::span<const Index> crossings,
                             Inside inside = Inside::Outwards);

}  // namespace remesher
