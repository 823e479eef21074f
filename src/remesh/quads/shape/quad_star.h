// SPDX-License-Identifier: MIT
// Quads on the original while their vertices move: how good the corners around a vertex are, and
// where the vertex may go. Inner vertices move on the surface, curve vertices along their curves,
// corners not at all.
#pragma once

#include <optional>

#include "geometry/quad.h"
#include "geometry/quad_facing.h"
#include "remesh/quads/mesh/quad_mesh.h"
#include "remesh/quads/mesh/quad_sides.h"

namespace remesher {

class MovingQuads {
 public:
  // ground: any mesh on the same original. The quads must be a manifold, and outlive this. With
  // `facing`, which must too, quads that face away are folded.
  MovingQuads(QuadMesh& mesh, const WorkingMesh& ground, const QuadFacing* facing = nullptr)
      : mesh_(mesh), ground_(ground), facing_(facing), sides_(mesh.vertices.size(), mesh.quads) {}

  const QuadMesh& mesh() const { return mesh_; }
  const QuadSides& sides() const { return sides_; }
  Quad corners(Index quad) const;

  // The smallest sine of the quad's corners, negative where it folds over or is reflex.
  double quality(Index quad) const;
  // The smallest quality of the quads around v.
  double qualityAround(Index v) const;

  // The place nearest to p that v may move to, if v may move.
  std::optional<Placement> placeNear(Index v, const Vec3& p) const;

  void move(Index v, const Placement& place) { mesh_.vertices[v] = place; }

  // Moves v, unless the worst corner around it gets worse than both before and `enough`.
  bool moveUnlessWorse(Index v, const Placement& place, double enough);

 private:
  std::optional<Placement> alongCurve(Index v, const Vec3& p) const;
  double qualityAlone(Index quad) const;

  QuadMesh& mesh_;
  const WorkingMesh& ground_;
  const QuadFacing* facing_;
  const QuadSides sides_;
};

}  // namespace remesher
