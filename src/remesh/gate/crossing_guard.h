// SPDX-License-Identifier: MIT
// A gate against triangles that intersect others, however far apart along the surface, or have no
// area: a mesh free of both stays free of both, as written.
#pragma once

#include <span>
#include <vector>

#include "geometry/triangle_grid.h"
#include "geometry/triangle_meeting.h"
#include "remesh/gate/quantum.h"
#include "remesh/operators/local_change.h"

namespace remesher {

// The functions that steps call are virtual: an engine that never makes a guard then holds none of
// its code.
class CrossingGuard {
 public:
  CrossingGuard(const WorkingMesh& mesh, const Quantum& quantum);
  virtual ~CrossingGuard() = default;

  // How many more pairs of triangles would intersect outside their shared vertices and edges; if
  // more, then at least one.
  std::ptrdiff_t growth(const LocalChange& change) const;

  // Whether a change makes no more such pairs, and no triangle turns past a neighbour.
  virtual bool allows(const LocalChange& change) const;

  // Must be called after each change, with the vertex that it made, moved or kept.
  virtual void update(const LocalChange& change, Vertex result);

  // The triangles that intersect others, ascending.
  std::vector<Face> crossing() const;
  // The triangles that this one intersects; itself if it has no area.
  std::vector<Face> metBy(Face f) const;

 private:
  NamedTriangle present(Face f) const;
  NamedTriangle coming(const LocalChange& change, const std::array<Vertex, 3>& corners) const;
  template <class Visit>
  void forEachMet(const NamedTriangle& t, std::span<const Face> leftOut, Visit visit) const;
  std::size_t countAround(const NamedTriangle& t, std::span<const Face> leftOut) const;
  // Stops after a triangle with which there are enough.
  std::size_t countAmong(std::span<const NamedTriangle> triangles, std::span<const Face> leftOut,
                         std::size_t enough) const;
  bool turnsPast(std::span<const NamedTriangle> after, std::span<const Face> gone) const;
  void enterAll();

  const WorkingMesh& mesh_;
  Quantum quantum_;
  TriangleGrid grid_;
  std::size_t added_ = 0;  // entries since all were entered
};

}  // namespace remesher
