// SPDX-License-Identifier: MIT
#include "original/curves/shape_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/fast_trigonometry.h"
#include "geometry/triangle.h"

namespace remesher {

FaceData<Vec3> faceNormals(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions) {
  FaceData<Vec3> normals(mesh.faceCapacity());
  for (Index f = 0; f < mesh.faceCapacity(); ++f) {
    const auto [a, b, c] = mesh.vertices(Face(f));
    normals[Face(f)] = unitNormal(positions[a], positions[b], positions[c]);
  }
  return normals;
}

double dihedralAngle(const HalfedgeMesh& mesh, const FaceData<Vec3>& normals, Halfedge h) {
  if (mesh.isBoundary(h)) return 0;
  const Vec3 &n = normals[mesh.face(h)], &m = normals[mesh.face(mesh.twin(h))];
  // A face without area has no normal, and its edges no angle.
  if (n.isZero() || m.isZero()) return 0;
  return angleOf(n.cross(m).norm(), n.dot(m));
}

// Angles are worked out for the few edges that may be sharp.
HalfedgeData<char> sharpEdges(const HalfedgeMesh& mesh, const FaceData<Vec3>& normals,
                              double angle) {
  constexpr double kRounding = 1e-6;
  const double flat = std::cos(std::clamp(angle, 0.0, std::numbers::pi)) + kRounding;
  HalfedgeData<char> sharp(mesh.halfedgeCapacity(), angle <= 0);
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i), t = mesh.twin(h);
    if (!t || t < h || normals[mesh.face(h)].dot(normals[mesh.face(t)]) > flat) continue;
    sharp[h] = sharp[t] = dihedralAngle(mesh, normals, h) >= angle;
  }
  return sharp;
}

double missingAngle(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, Vertex v) {
  if (mesh.isBoundary(v)) return 0;
  double missing = 2 * std::numbers::pi;
  mesh.forEachOutgoing(v, [&](Halfedge h) {
    const Vec3 a = positions[mesh.tip(h)] - positions[v];
    const Vec3 b = positions[mesh.opposite(h)] - positions[v];
    missing -= angleOf(a.cross(b).norm(), a.dot(b));
  });
  return missing;
}

VertexData<char> mayMiss(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                         double angle) {
  constexpr double kRounding = 1e-6;
  const double least = 1 - angle / (2 * std::numbers::pi) + kRounding;  // cosine
  VertexData<char> result(mesh.vertexCapacity(), 0);
  VertexData<Vec3> first(mesh.vertexCapacity(), Vec3::Zero());  // normal, not unit, at each
  for (Index f = 0; f < mesh.faceCapacity(); ++f) {
    const auto corners = mesh.vertices(Face(f));
    const Vec3 normal =
        areaVector(positions[corners[0]], positions[corners[1]], positions[corners[2]]);
    const double squared = least * least * normal.squaredNorm();
    for (const Vertex v : corners) {
      Vec3& own = first[v];
      if (own.isZero(0)) own = normal;
      const double product = own.dot(normal);
      result[v] |= !(product > 0 && product * product >= squared * own.squaredNorm());
    }
  }
  return result;
}

std::vector<double> edgeLengths(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions) {
  std::vector<double> lengths;
  lengths.reserve(mesh.halfedgeCapacity() / 2);
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (mesh.isEdge(h))
      lengths.push_back((positions[mesh.tip(h)] - positions[mesh.origin(h)]).norm());
  }
  return lengths;
}

}  // namespace remesher
