// SPDX-License-Identifier: MIT
// A gate that no triangle passes which meets others, however far apart along the surface they are,
// or has no area: what was free of both stays so, in the numbers that are written.
#pragma once

#include <span>
#include <vector>

#include "geometry/triangle_grid.h"
#include "geometry/triangle_meeting.h"
#include "remesh/gate/grain.h"
#include "remesh/operators/local_change.h"

namespace remesher {

// What steps call is virtual: an engine that never makes a guard then holds none of its code.
class CrossingGuard {
 public:
  CrossingGuard(const WorkingMesh& mesh, const Grain& grain);
  virtual ~CrossingGuard() = default;

  // How many more pairs of triangles would meet elsewhere than at what they share.
  std::ptrdiff_t growth(const LocalChange& change) const;

  // Whether a change makes any more.
  virtual bool allows(const LocalChange& change) const;

  // To be told of each change that was carried out, with the vertex that it made, moved or kept.
  virtual void update(const LocalChange& change, Vertex result);

  // The triangles that meet others, ascending.
  std::vector<Face> crossing() const;
  bool isCrossed(Face f) const;

 private:
  NamedTriangle present(Face f) const;
  NamedTriangle coming(const LocalChange& change, const std::array<Vertex, 3>& corners) const;
  std::size_t countAround(const NamedTriangle& t, std::span<const Face> leftOut) const;
  std::size_t countAmong(std::span<const NamedTriangle> triangles,
                         std::span<const Face> leftOut) const;

  const WorkingMesh& mesh_;
  Grain grain_;
  TriangleGrid grid_;
};

}  // namespace remesher
