// SPDX-License-Identifier: MIT
// Shapes as originals, with their sharp edges as feature curves, and what must hold of a working
// mesh on them whatever was done to it.
#pragma once

#include <algorithm>
#include <numbers>
#include <string>

#include "geometry/triangle.h"
#include "remesh/gate/angles.h"
#include "remesh/operators/working_mesh.h"
#include "support/mesh_check.h"
#include "support/shapes.h"
#include "support/soups.h"

namespace remesher::shapes {

enum class Features { Sharp, None };  // edges bent by more than 40°; boundaries are curves anyway

inline OriginalSurface surfaceOf(const TriangleMesh& input, Features features = Features::Sharp) {
  BuiltMesh built = buildMesh(input);
  const HalfedgeMesh& m = built.mesh;
  const auto normal = [&](Halfedge h) {
    const auto [a, b, c] = m.vertices(m.face(h));
    return unitNormal(built.positions[a], built.positions[b], built.positions[c]);
  };
  CurveRules rules;
  for (Index i = 0; features == Features::Sharp && i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (m.isBoundary(h) || !m.isEdge(h)) continue;
    if (normal(h).dot(normal(m.twin(h))) < std::cos(radians(40))) rules.edges.push_back(h);
  }
  FeatureCurves curves(m, built.positions, rules);
  return OriginalSurface(std::move(built), std::move(curves));
}

// As a caller would get it.
inline TriangleMesh arraysOf(WorkingMesh mesh) {
  mesh.compact();
  TriangleMesh arrays;
  arrays.positions = mesh.positions().values();
  arrays.indices = mesh.mesh().triangles();
  return arrays;
}

// The curve edges at v, each as the halfedge at hand.
inline std::vector<Halfedge> curveEdgesAt(const WorkingMesh& mesh, Vertex v) {
  std::vector<Halfedge> result;
  mesh.mesh().forEachOutgoing(v, [&](Halfedge h) {
    if (mesh.isCurve(h)) result.push_back(h);
    const Halfedge back = mesh.mesh().prev(h);
    if (mesh.mesh().isBoundary(back)) result.push_back(back);
  });
  return result;
}

inline std::string brokenVertex(const WorkingMesh& mesh, Vertex v) {
  const std::vector<Halfedge> edges = curveEdgesAt(mesh, v);
  const Placement place = mesh.placement(v);
  switch (mesh.kind(v)) {
    case VertexKind::Interior:
      if (!edges.empty()) return "an interior vertex lies on a curve edge";
      if ((mesh.surface().position(place.at) - place.position).norm() > 1e-9)
        return "an interior vertex is not where its surface point is";
      return {};
    case VertexKind::Curve:
      if (edges.size() != 2) return "a curve vertex has not two curve edges";
      for (const Halfedge h : edges)
        if (mesh.curve(h) != place.on.chain) return "a curve vertex lies on another chain";
      if ((mesh.onCurve(place.on).position - place.position).norm() > 1e-9)
        return "a curve vertex is not where its curve point is";
      return {};
    case VertexKind::Corner:
      if ((mesh.surface().position(place.at) - place.position).norm() > 0)
        return "a corner has moved";
      return {};
  }
  return {};
}

// Each chain is a path from one of its corners to the other that never turns back: then and only
// then the pieces of its edges add up to its length.
inline std::string brokenChain(const WorkingMesh& mesh) {
  const auto& chains = mesh.surface().curves().chains();
  std::vector<double> covered(chains.size(), 0);
  const HalfedgeMesh& m = mesh.mesh();
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!m.isAlive(h)) continue;
    if (m.isBoundary(h) && !mesh.isCurve(h)) return "a boundary edge is on no curve";
    if (!m.isBoundary(h) && mesh.curve(h) != mesh.curve(m.twin(h)))
      return "the two sides of an edge are on different curves";
    if (!m.isEdge(h) || !mesh.isCurve(h)) continue;
    const Index chain = mesh.curve(h);
    covered[chain] +=
        std::abs(mesh.onChain(m.origin(h), chain).arc - mesh.onChain(m.tip(h), chain).arc);
  }
  for (Index c = 0; c < chains.size(); ++c)
    if (std::abs(covered[c] - chains[c].length()) > 1e-9 * chains[c].length())
      return "a chain is not covered from end to end";
  return {};
}

// The smallest angle of all its triangles, in radians.
inline double worstAngle(const WorkingMesh& mesh) {
  double worst = std::numbers::pi;
  for (Index i = 0; i < mesh.mesh().faceCapacity(); ++i)
    if (mesh.mesh().isAlive(Face(i))) worst = std::min(worst, smallestAngle(mesh, Face(i)));
  return worst;
}

// The first broken law in words, empty if all hold.
inline std::string checkWorkingMesh(const WorkingMesh& mesh) {
  if (std::string broken = check(mesh.mesh()); !broken.empty()) return broken;
  for (Index i = 0; i < mesh.mesh().vertexCapacity(); ++i) {
    if (!mesh.mesh().isAlive(Vertex(i))) continue;
    if (std::string broken = brokenVertex(mesh, Vertex(i)); !broken.empty()) return broken;
  }
  return brokenChain(mesh);
}

}  // namespace remesher::shapes
