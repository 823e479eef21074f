// SPDX-License-Identifier: MIT
// The shapes as built surfaces, for tests of what lives on the original surface.
#pragma once

#include <string>
#include <vector>

#include "geometry/surface_point.h"
#include "mesh/mesh_builder.h"
#include "support/shapes.h"

namespace remesher::surfaces {

struct Surface {
  std::string name;
  BuiltMesh built;

  const HalfedgeMesh& mesh() const { return built.mesh; }
  const VertexData<Vec3>& positions() const { return built.positions; }

  Vec3 position(const SurfacePoint& p) const {
    const auto [a, b, c] = mesh().vertices(p.face);
    return p.barycentric[0] * positions()[a] + p.barycentric[1] * positions()[b] +
           p.barycentric[2] * positions()[c];
  }

  // A vertex as a corner of one of its faces.
  SurfacePoint at(Vertex v) const {
    const Halfedge h = mesh().outgoing(v);
    SurfacePoint p{HalfedgeMesh::face(h), Vec3::Zero()};
    p.barycentric[Eigen::Index(h.index % 3)] = 1;
    return p;
  }
};

inline Surface surface(const std::string& name, const TriangleMesh& mesh) {
  return {name, buildMesh(mesh)};
}

inline std::vector<Surface> all() {
  std::vector<Surface> result;
  for (const shapes::Shape& shape : shapes::all())
    result.push_back(surface(shape.name, shape.mesh));
  result.push_back(surface("large icosphere", shapes::icosphere(7)));
  result.push_back(surface("large torus", shapes::torus(24, 12)));
  result.push_back(surface("large grid", shapes::grid(20, 20)));
  return result;
}

// Both halfedges of every edge whose two ends satisfy the condition.
template <class Condition>
HalfedgeData<char> barriersBetween(const Surface& surface, Condition isOn) {
  HalfedgeData<char> barriers(surface.mesh().halfedgeCapacity(), 0);
  for (Index i = 0; i < surface.mesh().halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    barriers[h] = isOn(surface.positions()[surface.mesh().origin(h)]) &&
                  isOn(surface.positions()[surface.mesh().tip(h)]);
  }
  return barriers;
}

}  // namespace remesher::surfaces
