// SPDX-License-Identifier: MIT
#include "remesh/gate/angles.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "support/working_meshes.h"

using namespace remesher;

TEST_CASE("angles: a limit is above exactly the triangles whose smallest angle is less") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(4), shapes::Features::None);
  WorkingMesh mesh(surface);
  Random random(1820001);
  for (Index i = 0; i < mesh.mesh().vertexCapacity(); ++i) {
    Placement place = mesh.placement(Vertex(i));
    for (double& x : place.position) x += 0.2 * (random.uniform() - 0.5);
    mesh.move(Vertex(i), place);
  }
  // One without area.
  mesh.move(mesh.mesh().vertices(Face(0))[0], mesh.placement(mesh.mesh().vertices(Face(0))[1]));
  for (Index i = 0; i < mesh.mesh().faceCapacity(); ++i) {
    const Face f(i);
    const double own = smallestAngle(mesh, f);
    CAPTURE(own);
    CHECK_FALSE(AngleLimit(own).isAbove(mesh, f));
    CHECK(AngleLimit(std::nextafter(own, 2)).isAbove(mesh, f));
    for (const double degrees : {1, 10, 30, 45, 60})
      CHECK(AngleLimit(radians(degrees)).isAbove(mesh, f) == (own < radians(degrees)));
  }
}
