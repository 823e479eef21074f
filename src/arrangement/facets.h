// SPDX-License-Identifier: MIT
// Cuts triangles along each other: facets that meet in common corners and edges only, where each
// knows the triangles that contain it.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "arrangement/points.h"
#include "geometry/triangle_tree.h"

namespace remesher {

// What is known beforehand of the triangles that meet others.
struct KnownMeetings {
  std::optional<std::vector<Index>> triangles;  // the only ones that may; ascending
  // Whether no triangle meets others of its own operand. Then there are two operands, that of
  // number 0 first, and `triangles` are known.
  bool isEachSound = false;
};

// The triangles to arrange, with points of a pool as corners.
struct ArrangedTriangles {
  const std::vector<Index>& corners;                // three per triangle
  const std::vector<Index>& operands;               // one per triangle
  const std::function<const TriangleTree&()> tree;  // of all, built when it is first asked for
  const KnownMeetings& known;

  GivenPlane operator[](Index t) const {
    return {corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]};
  }
  std::size_t size() const { return operands.size(); }
};

struct FacetParent {
  Index triangle;
  int sign;  // 1 where the facet is oriented like the triangle, else -1
};

struct Facets {
  std::vector<Index> corners;  // three per facet
  // Of facet f: from firstParents[f] to firstParents[f + 1]; the first has the lowest number, and
  // the sign 1. Facets are in the order of their first parents.
  std::vector<FacetParent> parents;
  std::vector<Index> firstParents = {0};
  std::vector<std::uint8_t> isCut;  // per triangle whether it met others
  std::size_t cutTriangles = 0;
  std::size_t work = 0;  // steps

  std::size_t size() const { return firstParents.size() - 1; }
  std::span<const FacetParent> parentsOf(Index f) const {
    return std::span(parents).subspan(firstParents[f], firstParents[f + 1] - firstParents[f]);
  }
  Index parent(Index f) const { return parents[firstParents[f]].triangle; }
};

// Nothing if that would take more than so many steps. An untouched triangle is its own facet, with
// its corners in their order.
std::optional<Facets> cutTriangles(PointPool& points, const ArrangedTriangles& triangles,
                                   std::size_t mostWork);

}  // namespace remesher
