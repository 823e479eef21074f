// SPDX-License-Identifier: MIT
#include "original/patches/face_cells.h"

#include <doctest/doctest.h>

#include "support/surfaces.h"

using namespace remesher;
using surfaces::Surface;

TEST_CASE("face_cells: every face lies in exactly the cell that lists it") {
  for (const Surface& surface : surfaces::all()) {
    CAPTURE(surface.name);
    const auto frames = faceFrames(surface.mesh(), surface.positions());
    for (const std::size_t size : {1u, 10u, 100u}) {
      const FaceCells cells = partitionFaces(surface.mesh(), frames, {}, size);
      std::vector<int> listed(surface.mesh().faceCapacity(), 0);
      for (Index cell = 0; cell < cells.count(); ++cell)
        for (const Face f : cells.faces(cell)) {
          CHECK(cells.cellOf(f) == cell);
          ++listed[f.index];
        }
      CHECK(std::count(listed.begin(), listed.end(), 1) == std::ssize(listed));
    }
  }
}

TEST_CASE("face_cells: cells are connected, and do not cross barriers") {
  const Surface plane = surfaces::surface("", shapes::grid(20, 20));
  const auto barriers = barriersBetween(plane, [](const Vec3& p) { return p.y() == 7; });
  const auto frames = faceFrames(plane.mesh(), plane.positions());
  const FaceCells cells = partitionFaces(plane.mesh(), frames, barriers.values(), 50);
  for (Index cell = 0; cell < cells.count(); ++cell) {
    const auto faces = cells.faces(cell);
    for (std::size_t n = 1; n < faces.size(); ++n) {
      bool joined = false;
      for (int i = 0; i < 3; ++i) {
        const Halfedge side = HalfedgeMesh::halfedge(faces[n], i), t = plane.mesh().twin(side);
        if (!t || barriers[side]) continue;
        joined |= std::find(faces.begin(), faces.begin() + std::ptrdiff_t(n),
                            HalfedgeMesh::face(t)) != faces.begin() + std::ptrdiff_t(n);
      }
      CHECK(joined);
      CHECK((frames[faces[n]].centroid.y() < 7) == (frames[faces[0]].centroid.y() < 7));
    }
  }
}

TEST_CASE("face_cells: cells are of about the wanted size and nearly flat") {
  const Surface sphere = surfaces::surface("", shapes::icosphere(20));
  const auto frames = faceFrames(sphere.mesh(), sphere.positions());
  const FaceCells cells = partitionFaces(sphere.mesh(), frames, {}, 100);
  // 8000 faces: 80 cells if all were full; fragments are shared out, so not many more.
  CHECK(cells.count() >= 60);
  CHECK(cells.count() <= 130);
  for (Index cell = 0; cell < cells.count(); ++cell)
    for (const Face f : cells.faces(cell))
      CHECK(frames[f].normal.dot(frames[cells.faces(cell)[0]].normal) > 0.2f);
}
