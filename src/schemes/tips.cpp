// SPDX-License-Identifier: MIT
#include "schemes/tips.h"

#include <algorithm>

#include "geometry/triangle.h"
#include "geometry/triangle_tree.h"

namespace remesher {

namespace {

// A tip is worth a triangle of this angle for now: smoothing and polish follow.
constexpr double kSmallestAngle = radians(20);

struct Tip {
  double distance;  // to the mesh
  Vertex original;
  Face nearest;  // of the mesh
};

std::vector<Tip> farTips(const Run& run, double tolerance) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const OriginalSurface& surface = run.mesh.surface();
  const std::vector<Index> triangles = mesh.triangles();
  std::vector<Face> faces;
  for (Index f = 0; f < mesh.faceCapacity(); ++f)
    if (mesh.isAlive(Face(f))) faces.push_back(Face(f));
  const TriangleTree tree(run.mesh.positions().values(), triangles);
  std::vector<Tip> tips;
  TriangleTree::Nearest near;
  for (Index i = 0; i < surface.mesh().vertexCapacity(); ++i) {
    const Vertex v(i);
    if (!surface.mesh().isAlive(v)) continue;
    const Vec3& p = surface.positions()[v];
    near = near.triangle == kNone ? tree.nearest(p) : tree.nearest(p, near.triangle);
    const double distance = std::sqrt(near.squaredDistance);
    if (distance > tolerance * run.scale * run.sizes.at(v))
      tips.push_back({distance, v, faces[near.triangle]});
  }
  std::stable_sort(tips.begin(), tips.end(),
                   [](const Tip& a, const Tip& b) { return a.distance > b.distance; });
  return tips;
}

double worstComing(const Run& run) {
  double worst = 10;
  const Vec3& moved = run.change.place.position;
  for (const auto& [v, a, b] : run.change.coming)
    worst = std::min(worst, minAngle(moved, run.mesh.position(a), run.mesh.position(b)));
  return worst;
}

bool moveTo(Run& run, Vertex v, const Placement& place) {
  if (run.mesh.kind(v) != VertexKind::Interior || run.pinned[v]) return false;
  proposePlacement(run.mesh, v, place, run.change);
  return worstComing(run) >= kSmallestAngle && commit(run);
}

}  // namespace

std::size_t reachTips(Run& run, double tolerance) {
  const OriginalSurface& surface = run.mesh.surface();
  run.pinned.resize(run.mesh.mesh().vertexCapacity(), 0);
  std::size_t moved = 0;
  for (const Tip& tip : farTips(run, tolerance)) {
    const Placement place = run.mesh.onSurface(surface.at(tip.original));
    auto corners = run.mesh.mesh().vertices(tip.nearest);
    const auto distance = [&](Vertex v) {
      return (run.mesh.position(v) - place.position).squaredNorm();
    };
    std::sort(corners.begin(), corners.end(),
              [&](Vertex a, Vertex b) { return distance(a) < distance(b); });
    // One pinned vertex reaches all the original's vertices around its tip.
    if (run.pinned[corners[0]]) continue;
    for (const Vertex v : corners) {
      if (!moveTo(run, v, place)) continue;
      run.pinned[v] = 1;
      ++moved;
      break;
    }
  }
  return moved;
}

}  // namespace remesher
