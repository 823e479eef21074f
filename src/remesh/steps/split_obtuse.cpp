// SPDX-License-Identifier: MIT
#include "remesh/steps/split_obtuse.h"

namespace remesher {

namespace {

bool facesObtuse(const WorkingMesh& mesh, Halfedge side) {
  if (!side) return false;
  const Vec3& apex = mesh.position(mesh.mesh().opposite(side));
  const Vec3 toOrigin = mesh.position(mesh.mesh().origin(side)) - apex;
  return toOrigin.dot(mesh.position(mesh.mesh().tip(side)) - apex) < 0;
}

}  // namespace

void splitObtuse(Run& run) {
  const HalfedgeMesh& m = run.mesh.mesh();
  std::vector<std::pair<Vertex, Vertex>> edges;
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!m.isEdge(h)) continue;
    if (facesObtuse(run.mesh, h) || facesObtuse(run.mesh, m.twin(h)))
      edges.emplace_back(m.origin(h), m.tip(h));
  }
  grantProofs(run);
  const ErrorBound* bound = run.asked.rule.bound;
  for (const auto& [from, to] : edges)
    if (proposeSplit(run.mesh, run.projector, m.find(from, to), run.scratch.change) &&
        !flattens(run.mesh, run.scratch.change, run.asked.rule.quantum) &&
        (!bound || bound->allows(run.mesh, run.scratch.change)))
      apply(run.mesh, run.scratch.change);
}

}  // namespace remesher
