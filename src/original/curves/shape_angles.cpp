// SPDX-License-Identifier: MIT
#include "original/curves/shape_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/fast_trigonometry.h"
#include "geometry/triangle.h"
#include "mesh/coordinate_step.h"

namespace remesher {

namespace {

struct Side {
  Halfedge halfedge;
  double squaredLength = -1;
};

Side longestSide(Face f, const Triangle& corners) {
  Side longest;
  for (int k = 0; k < 3; ++k) {
    const double own = (corners[(k + 1) % 3] - corners[k]).squaredNorm();
    if (own > longest.squaredLength) longest = {HalfedgeMesh::halfedge(f, k), own};
  }
  return longest;
}

// How far the triangles at an edge are off each other's planes, as corners: the nearer of the two.
double offPlane(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, Halfedge h) {
  double least = kInfinity;
  for (const Halfedge side : {h, mesh.twin(h)}) {
    const Vec3& origin = positions[mesh.origin(side)];
    const Vec3 normal =
        areaVector(origin, positions[mesh.tip(side)], positions[mesh.opposite(side)]);
    const double twice = normal.norm();
    if (!(twice > 0)) continue;
    const Vec3 way = positions[mesh.opposite(mesh.twin(side))] - origin;
    least = std::min(least, std::abs(normal.dot(way)) / twice);
  }
  return least;
}

// Coarse digits take flat faces farther off each other's planes than is expected of any: then their
// edges are by themselves, far below all that bend.
double withCoarseDigits(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                        double tolerance) {
  constexpr double kCoarse = 3, kGap = 4;
  const double coarse = kCoarse * tolerance;
  bool areCoarse = false;
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh.isEdge(h) || mesh.isBoundary(h)) continue;
    const double off = offPlane(mesh, positions, h);
    if (off > coarse && off <= kGap * coarse) return tolerance;
    areCoarse = areCoarse || (off > tolerance && off <= coarse);
  }
  return areCoarse ? coarse : tolerance;
}

}  // namespace

FaceData<Face> bearingFaces(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions) {
  const double step = coordinateStep(positions.values());
  FaceData<Face> beyond(mesh.faceCapacity());
  std::vector<Face> flat;
  for (Index i = 0; i < mesh.faceCapacity(); ++i) {
    const Face f(i);
    const auto [a, b, c] = mesh.vertices(f);
    const Triangle corners = {positions[a], positions[b], positions[c]};
    const auto [side, squared] = longestSide(f, corners);
    const double squaredTwice = areaVector(corners[0], corners[1], corners[2]).squaredNorm();
    beyond[f] = f;
    if (squaredTwice > step * step * squared || !mesh.twin(side)) continue;
    beyond[f] = HalfedgeMesh::face(mesh.twin(side));
    flat.push_back(f);
  }
  // Two flat faces that lead to each other have no bearer. Each pass at least doubles how many flat
  // faces every one of them looks across.
  FaceData<Face> bearers = std::move(beyond);
  for (std::size_t across = 1; across < flat.size(); across *= 2)
    for (const Face f : flat) bearers[f] = bearers[bearers[f]];
  return bearers;
}

FaceData<Vec3> faceNormals(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions) {
  const FaceData<Face> bearers = bearingFaces(mesh, positions);
  FaceData<Vec3> normals(mesh.faceCapacity());
  for (Index f = 0; f < mesh.faceCapacity(); ++f) {
    const auto [a, b, c] = mesh.vertices(bearers[Face(f)]);
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

// Angles are computed only for the few edges that may be sharp.
HalfedgeData<char> sharpEdges(const HalfedgeMesh& mesh, const FaceData<Vec3>& normals,
                              double angle) {
  const double flat = std::cos(std::clamp(angle, 0.0, std::numbers::pi)) + kSingleRoundOff;
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

double flatTolerance(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions) {
  // Coordinates with six digits are this far from where they were meant, as a share of the
  // diagonal; a triangle on a round surface is off its neighbor's plane by more of an edge.
  constexpr double kDigits = 4e-6, kOfEdges = 1e-3;
  const double step = coordinateStep(positions.values());
  double sum = 0;
  std::size_t edges = 0;
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh.isEdge(h)) continue;
    sum += distance(positions[mesh.origin(h)], positions[mesh.tip(h)]);
    ++edges;
  }
  if (edges == 0) return step;
  Vec3 low = positions.values().front(), high = low;
  for (const Vec3& p : positions.values()) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double tolerance =
      std::max(step, std::min(kDigits * (high - low).norm(), kOfEdges * sum / double(edges)));
  return withCoarseDigits(mesh, positions, tolerance);
}

double coplanarShare(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions) {
  const double step = flatTolerance(mesh, positions);
  double coplanar = 0, all = 0;
  for (Index i = 0; i < mesh.faceCapacity(); ++i) {
    const auto [a, b, c] = mesh.vertices(Face(i));
    const Vec3 normal = areaVector(positions[a], positions[b], positions[c]);
    const double twice = normal.norm();
    all += twice;
    for (int k = 0; k < 3; ++k) {
      const Halfedge across = mesh.twin(HalfedgeMesh::halfedge(Face(i), k));
      if (!across) continue;
      const double off = normal.dot(positions[mesh.opposite(across)] - positions[a]);
      if (std::abs(off) > step * twice) continue;
      coplanar += twice;
      break;
    }
  }
  return all > 0 ? coplanar / all : 0;
}

VertexData<char> mayMiss(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                         double angle) {
  const double least = 1 - angle / (2 * std::numbers::pi) + kSingleRoundOff;  // cosine
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
