// SPDX-License-Identifier: MIT
#include "remesh/accuracy/bound_error.h"

#include <doctest/doctest.h>

#include <cmath>

#include "measure/hausdorff.h"
#include "remesh/schemes/remesh.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

// A sphere with spikes, thin enough to get lost when it is remeshed coarsely.
TriangleMesh spikySphere() {
  TriangleMesh mesh = shapes::icosphere(4);
  for (Vec3& p : mesh.positions) p *= 1 + 0.6 * std::pow(std::abs(p.x() * p.y()) * 2, 12);
  return mesh;
}

struct Case {
  TriangleMesh shape;
  Index vertices;
  double error;
};

RemeshOutcome run(const Case& c, Scheme scheme) {
  PartOptions options;
  options.scheme = scheme;
  options.vertices = c.vertices;
  options.maxError = c.error;
  return remeshSurface(c.shape, options, {});
}

}  // namespace

TEST_CASE("max error: the result is within it, in both directions, whatever the scheme") {
  for (const Scheme scheme : {Scheme::Best, Scheme::Rounds})
    for (const Case& c :
         {Case{spikySphere(), 120, 0.3}, Case{shapes::torus(24, 12), 150, 0.5},
          Case{shapes::cylinder(12, 3), 60, 0.2}, Case{shapes::boxWithHole(), 100, 0.1}}) {
      const RemeshOutcome outcome = run(c, scheme);
      const FidelityReport fidelity = measureFidelity(c.shape, outcome.mesh, Maximum::Proven);
      CHECK(fidelity.hausdorff <= c.error);
      CHECK(outcome.mesh.positions.size() >= c.vertices);
      CHECK((outcome.stopped == Stopped::Target) == (outcome.mesh.positions.size() == c.vertices));
    }
}

TEST_CASE("max error: what cannot be had within it ends the run, and says so") {
  const Case c{spikySphere(), 20, 0.5};
  for (const Scheme scheme : {Scheme::Best, Scheme::Rounds}) {
    const RemeshOutcome outcome = run(c, scheme);
    CHECK(outcome.stopped == Stopped::MaxError);
    CHECK(outcome.mesh.positions.size() > 20);
    CHECK(measureFidelity(c.shape, outcome.mesh, Maximum::Proven).hausdorff <= c.error);
  }
}

TEST_CASE("max error: a bound that is kept anyway changes nothing of the count") {
  const RemeshOutcome outcome = run({shapes::torus(24, 12), 500, 5}, Scheme::Best);
  CHECK(outcome.stopped == Stopped::Target);
  CHECK(outcome.mesh.positions.size() == 500);
}

TEST_CASE("max error: however small, the original has it, and more vertices do not leave it") {
  const TriangleMesh shape = shapes::torus(12, 8);
  const RemeshOutcome outcome = run({shape, 140, 1e-10}, Scheme::Best);
  CHECK(outcome.stopped == Stopped::Target);
  CHECK(outcome.mesh.positions.size() == 140);
  CHECK(measureFidelity(shape, outcome.mesh, Maximum::Proven).hausdorff <= 1e-10);
}
