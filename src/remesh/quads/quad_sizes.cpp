// SPDX-License-Identifier: MIT
#include "remesh/quads/quad_sizes.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/triangle.h"
#include "remesh/quads/shape/smoothing.h"

namespace remesher {

namespace {

// Sizes lie within this factor of their mean.
constexpr double kMostApart = 1.25;

}  // namespace

double areaOf(const WorkingMesh& mesh) {
  double sum = 0;
  for (Index f = 0; f < mesh.mesh().faceCapacity(); ++f) {
    const auto [a, b, c] = mesh.corners(Face(f));
    sum += area(a, b, c);
  }
  return sum;
}

FaceData<double> evenSizes(const WorkingMesh& mesh) {
  return FaceData<double>(mesh.mesh().faceCapacity(), 1.0);
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
  for (Index f = 0; f < sizes.size(); ++f) {
    const auto [a, b, c] = m.vertices(Face(f));
    sizes[Face(f)] = (lengths[a] + lengths[b] + lengths[c]) / 3;
  }
  return sizes;
}

// With s the logarithm of the size, and θ the angle of the cross, s + iθ is holomorphic where the
// map is conformal: along an edge s changes by the bend of the cross across the edge. Each vertex
// has an s, least squares fit the edges; on curves crosses of both sides may bend as they like.
FaceData<double> crossSizes(const WorkingMesh& mesh, const FaceFrames& frames,
                            const CrossField& field) {
  const HalfedgeMesh& m = mesh.mesh();
  const auto count = Index(m.vertexCapacity());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd bends = Eigen::VectorXd::Zero(count);
  for (Index v = 0; v < count; ++v) entries.emplace_back(v, v, kTie);  // as a whole, s might be any
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!m.twin(h) || mesh.isCurve(h)) continue;
    const Index a = m.origin(h).index, b = m.tip(h).index;
    const double weight = 1 / dualWeight(mesh, frames, h);
    bends[a] += field.bend(frames, m, h) / 2;
    entries.emplace_back(a, a, weight);
    if (b < a) entries.emplace_back(a, b, -weight);
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd logs = Eigen::SimplicialLDLT(matrix).solve(bends);
  FaceData<double> sizes(m.faceCapacity());
  for (Index f = 0; f < sizes.size(); ++f) {
    const auto [a, b, c] = m.vertices(Face(f));
    const double mean = (logs[a.index] + logs[b.index] + logs[c.index]) / 3;
    sizes[Face(f)] = std::clamp(std::exp(mean), 1 / kMostApart, kMostApart);
  }
  return sizes;
}

FaceData<double> scaledToMean(FaceData<double> sizes, const WorkingMesh& mesh) {
  double squares = 0;
  for (Index f = 0; f < sizes.size(); ++f) {
    const auto [a, b, c] = mesh.corners(Face(f));
    squares += area(a, b, c) / (sizes[Face(f)] * sizes[Face(f)]);
  }
  const double factor = std::sqrt(squares / areaOf(mesh));
  for (Index f = 0; f < sizes.size(); ++f) sizes[Face(f)] *= factor;
  return sizes;
}

}  // namespace remesher
