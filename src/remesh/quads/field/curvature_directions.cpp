// SPDX-License-Identifier: MIT
#include "remesh/quads/field/curvature_directions.h"

#include <array>
#include <cmath>

namespace remesher {

namespace {

// The normals at the corners, interpolated over a triangle, change by a matrix times the step. The
// symmetric part of the matrix is the second fundamental form.
Complex directionIn(const WorkingMesh& mesh, const FaceFrames& frames, Face f) {
  const auto vertices = mesh.mesh().vertices(f);
  std::array<Vec2, 3> normals;
  for (std::size_t i = 0; i < 3; ++i)
    normals[i] = frames.inFrame(f, mesh.normalFacing(vertices[i], frames.normal(f)));
  const Vec2 ab = frames.edge(HalfedgeMesh::halfedge(f));
  const Vec2 ac = -frames.edge(HalfedgeMesh::halfedge(f, 2));
  const double twice = cross(ab, ac);
  if (!(twice > 0)) return 0;
  const Vec2 toB = normals[1] - normals[0], toC = normals[2] - normals[0];
  const Vec2 alongX = (toB * ac.y() - toC * ab.y()) / twice;
  const Vec2 alongY = (toC * ab.x() - toB * ac.x()) / twice;
  return {alongX.x() - alongY.y(), alongX.y() + alongY.x()};
}

FaceData<Complex> averaged(const WorkingMesh& mesh, const FaceFrames& frames,
                           const FaceData<Complex>& values) {
  const HalfedgeMesh& m = mesh.mesh();
  FaceData<Complex> result(values.size());
  for (Index i = 0; i < values.size(); ++i) {
    Complex sum = frames.area(Face(i)) * values[Face(i)];
    double areas = frames.area(Face(i));
    for (int corner = 0; corner < 3; ++corner) {
      const Halfedge twin = m.twin(HalfedgeMesh::halfedge(Face(i), corner));
      if (!twin || mesh.isCurve(twin)) continue;
      const Face other = HalfedgeMesh::face(twin);
      sum += frames.area(other) * values[other] * std::polar(1.0, 2 * frames.between(twin));
      areas += frames.area(other);
    }
    result[Face(i)] = areas > 0 ? sum / areas : 0;
  }
  return result;
}

}  // namespace

// Averaged once with the neighbours.
FaceData<Complex> curvatureDirections(const WorkingMesh& mesh, const FaceFrames& frames) {
  FaceData<Complex> result(mesh.mesh().faceCapacity());
  for (Index i = 0; i < result.size(); ++i) result[Face(i)] = directionIn(mesh, frames, Face(i));
  return averaged(mesh, frames, result);
}

}  // namespace remesher
