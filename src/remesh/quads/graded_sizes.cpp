// SPDX-License-Identifier: MIT
#include "remesh/quads/graded_sizes.h"

#include <cmath>

#include "geometry/triangle.h"

namespace remesher {

double areaOf(const WorkingMesh& mesh) {
  double sum = 0;
  for (Index f = 0; f < mesh.mesh().faceCapacity(); ++f) {
    const auto [a, b, c] = mesh.corners(Face(f));
    sum += area(a, b, c);
  }
  return sum;
}

FaceData<double> gradedSizes(const WorkingMesh& mesh) {
  const HalfedgeMesh& m = mesh.mesh();
  VertexData<double> lengths(m.vertexCapacity());
  for (Index v = 0; v < lengths.size(); ++v) lengths[Vertex(v)] = mesh.meanSpoke(Vertex(v));
  for (int i = 0; i < kSmoothingSweeps; ++i) {
    const VertexData<double> before = lengths;
    for (Index v = 0; v < lengths.size(); ++v) {
      double sum = 0;
      m.forEachNeighbor(Vertex(v), [&](Vertex w) { sum += before[w]; });
      lengths[Vertex(v)] = (before[Vertex(v)] + sum / m.valence(Vertex(v))) / 2;
    }
  }
  FaceData<double> sizes(m.faceCapacity());
  double squares = 0;
  for (Index f = 0; f < sizes.size(); ++f) {
    const auto [a, b, c] = m.vertices(Face(f));
    sizes[Face(f)] = (lengths[a] + lengths[b] + lengths[c]) / 3;
    const auto [p, q, r] = mesh.corners(Face(f));
    squares += area(p, q, r) / (sizes[Face(f)] * sizes[Face(f)]);
  }
  const double factor = std::sqrt(squares / areaOf(mesh));
  for (Index f = 0; f < sizes.size(); ++f) sizes[Face(f)] *= factor;
  return sizes;
}

}  // namespace remesher
