// SPDX-License-Identifier: MIT
#include "remesh/ground/proxy.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "mesh/topology.h"
#include "remesh/accuracy/places.h"
#include "remesh/ground/decimate.h"
#include "remesh/schemes/reproject.h"
#include "remesh/steps/sweeps.h"
#include "support/runs.h"

using namespace remesher;

namespace {

// A half of a cylinder's height is a tenth of what its edges are to be, and it has two boundaries.
TriangleMesh fineCylinder() { return shapes::cylinder(90, 40); }

}  // namespace

TEST_CASE("proxy: it has fewer vertices, all of the original's, and the same topology") {
  const OriginalSurface original = shapes::surfaceOf(shapes::icosphere(24), shapes::Features::None);
  const Proxy proxy(original, 0.15);
  const OriginalSurface& surface = proxy.surface();
  CHECK(surface.mesh().vertexCount() < original.mesh().vertexCount() / 3);
  CHECK(eulerCharacteristic(surface.mesh()) == 2);
  for (Index v = 0; v < surface.mesh().vertexCapacity(); ++v) {
    const Vertex there = proxy.onOriginal(Vertex(v));
    CHECK(surface.positions()[Vertex(v)] == original.positions()[there]);
    CHECK(proxy.collapseMap()[there] == Vertex(v));
  }
}

TEST_CASE("proxy: curves are the same, place by place") {
  const OriginalSurface original = shapes::surfaceOf(fineCylinder());
  const Proxy proxy(original, 0.1 * original.diagonal());
  const FeatureCurves &now = proxy.surface().curves(), &before = original.curves();
  CHECK(proxy.surface().mesh().vertexCount() < original.mesh().vertexCount());
  REQUIRE(now.chains().size() == before.chains().size());
  for (Index c = 0; c < now.chains().size(); ++c) {
    CHECK(now.chains()[c].arcs == before.chains()[c].arcs);
    for (const double share : {0.0, 0.3, 0.77, 1.0}) {
      const CurvePoint point{c, share * now.chains()[c].length()};
      CHECK((now.locate(proxy.surface().mesh(), proxy.surface().positions(), point).position -
             before.locate(original.mesh(), original.positions(), point).position)
                .norm() == 0);
    }
  }
}

TEST_CASE("proxy: what is far from a coarse mesh is seen from its vertices, which are few") {
  const OriginalSurface original = shapes::surfaceOf(shapes::icosphere(24), shapes::Features::None);
  const Proxy proxy(original, 0.1);
  SizeField sizes(proxy.surface(), {.vertices = 40});
  Projector projector(proxy.surface());
  WorkingMesh mesh(proxy.surface());
  decimate(mesh, {}, VertexData<double>(mesh.mesh().vertexCapacity(), 0.6));
  Run run{mesh, projector, sizes, {}};
  run.grounds.proxy = &proxy;
  reproject(run);
  const auto look = [&] { return measurePlaces(run, 0, 0); };
  const auto farthest = [](const std::vector<Place>& places) {
    double most = 0;
    for (const Place& place : places) most = std::max(most, place.distance);
    return most;
  };
  const std::vector<Place> few = look();
  run.grounds.thinned.reset();
  const std::vector<Place> all = look();
  CHECK(few.size() <= proxy.surface().mesh().vertexCount());
  CHECK(all.size() > 2 * few.size());
  CHECK(farthest(few) > 0.9 * farthest(all));
}

TEST_CASE("proxy: a reprojected mesh lies on the original, its curve vertices where they were") {
  const OriginalSurface original = shapes::surfaceOf(fineCylinder());
  const Proxy proxy(original, 0.1 * original.diagonal());
  SizeField sizes(proxy.surface(), {.vertices = 300, .adaptivity = 0.5});
  Projector projector(proxy.surface(), Projection::Patches, 2 * sizes.mean());
  WorkingMesh mesh(proxy.surface());
  Run run{mesh, projector, sizes, {}};
  run.grounds.proxy = &proxy;
  laplacianSweep(run);
  const WorkingMesh before = mesh;
  reproject(run);
  CHECK(run.grounds.proxy == nullptr);
  CHECK(&mesh.surface() == &original);
  CHECK(shapes::checkWorkingMesh(mesh) == "");
  for (Index i = 0; i < mesh.mesh().vertexCapacity(); ++i) {
    const Vertex v(i);
    CHECK((mesh.position(v) - original.position(mesh.at(v))).norm() < 1e-12 * original.diagonal());
    CHECK((mesh.position(v) - before.position(v)).norm() < 0.02 * original.diagonal());
    if (mesh.kind(v) != VertexKind::Interior) CHECK(mesh.position(v) == before.position(v));
    CHECK(sizes.at(mesh.at(v)) > 0);
  }
  laplacianSweep(run);
  CHECK(shapes::checkWorkingMesh(mesh) == "");
}
