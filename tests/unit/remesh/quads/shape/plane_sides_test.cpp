// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/plane_sides.h"

#include <doctest/doctest.h>

#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/mesh/quad_sides.h"
#include "support/quad_sheets.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

// Inner sides whose ends both lie on the border.
std::size_t countAcross(const QuadMesh& mesh) {
  const QuadSides sides(mesh.vertices.size(), mesh.quads);
  std::size_t count = 0;
  for (Index side = 0; side < sides.size(); ++side)
    count += sides.across(side) != kNone && sides.isBoundary(sides.origin(side)) &&
             sides.isBoundary(sides.tip(side));
  return count;
}

std::size_t countCorners(const QuadMesh& mesh) {
  const QuadSides sides(mesh.vertices.size(), mesh.quads);
  std::size_t count = 0;
  for (Index v = 0; v < mesh.vertices.size(); ++v) count += sides.quadsAround(v) == 1;
  return count;
}

}  // namespace

TEST_CASE("plane sides: of quads with all borders on a plane no image meets another off it") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(6, 4));
  const WorkingMesh ground(surface);
  const Mirrors mirrors{{{Vec3::UnitZ(), 0}}, 1e-9, 0};
  for (const Index rows : {1U, 2U, 3U}) {
    CAPTURE(rows);
    QuadMesh mesh = shapes::quadSheet(5, rows, shapes::Wraps::No, shapes::flat);
    const QuadSides sides(mesh.vertices.size(), mesh.quads);
    for (Index v = 0; v < mesh.vertices.size(); ++v) {
      Placement& place = mesh.vertices[v];
      place.at = {Face(0), {1, 0, 0}};
      place.kind = sides.isBoundary(v) ? VertexKind::Curve : VertexKind::Interior;
    }
    const SurfaceKind kind = kindOf(mesh);
    CHECK(countCorners(mesh) == 4);
    CHECK((countAcross(mesh) > 0) == (rows == 1));
    CHECK(partFromImages(mesh, mirrors, ground) > 0);
    CHECK(check(mesh) == "");
    CHECK(kindOf(mesh) == kind);
    CHECK(countAcross(mesh) == 0);
    CHECK(countCorners(mesh) == 0);
    CHECK(partFromImages(mesh, mirrors, ground) == 0);
  }
}

TEST_CASE("plane sides: quads off the planes stay as they are") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(6, 4));
  const WorkingMesh ground(surface);
  QuadMesh mesh = shapes::quadSheet(5, 1, shapes::Wraps::No, shapes::flat);
  for (Placement& place : mesh.vertices) place.kind = VertexKind::Curve;
  const std::vector<Four<Index>> before = mesh.quads;
  CHECK(partFromImages(mesh, {{{Vec3::UnitY(), 0}}, 1e-9, 0}, ground) == 0);
  CHECK(mesh.quads == before);
}
