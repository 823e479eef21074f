// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/quad_distance.h"

#include <algorithm>
#include <cmath>

#include "geometry/distance_sampler.h"
#include "remesh/quads/mesh/triangulated.h"

namespace remesher {

namespace {

// Where quads leave the surface, many do.
constexpr std::size_t kSomeQuads = 500;

// The side of a square as large as the mean quad.
double quadSide(const QuadMesh& quads) {
  double twiceArea = 0;
  for (const auto& [a, b, c, d] : quads.quads)
    twiceArea +=
        (quads.position(c) - quads.position(a)).cross(quads.position(d) - quads.position(b)).norm();
  return twiceArea > 0 ? std::sqrt(twiceArea / 2 / double(quads.quads.size())) : 0;
}

}  // namespace

QuadTree::QuadTree(const QuadMesh& mesh) : indices_(trianglesOf(mesh)) {
  for (const Placement& place : mesh.vertices) positions_.push_back(place.position);
  tree_.emplace(positions_, indices_);
}

std::array<Index, 3> QuadTree::corners(Index triangle) const {
  const std::size_t first = std::size_t{3} * triangle;
  return {indices_[first], indices_[first + 1], indices_[first + 2]};
}

QuadDistance::QuadDistance(const WorkingMesh& mesh)
    : mesh_(mesh), tree_(mesh.mesh(), mesh.positions()) {}

double QuadDistance::sidesAway(const QuadMesh& quads, double least) const {
  const double side = quadSide(quads), enough = least * side;
  if (!(side > 0)) return 0;
  const QuadTree tree(quads);
  DistanceSampler ofMesh(*tree);
  for (const Vec3& p : mesh_.positions().values()) ofMesh.addBeyond(enough, p);
  const double away = ofMesh.farthest() / side;
  return std::max(away < least ? 0 : away, quadsAway(quads, least));
}

double QuadDistance::quadsAway(const QuadMesh& quads, double least) const {
  const double side = quadSide(quads), enough = least * side;
  if (!(side > 0)) return 0;
  DistanceSampler ofQuads(tree_.triangles());
  for (std::size_t q = 0; q < quads.quads.size(); q += 1 + quads.quads.size() / kSomeQuads) {
    const auto& [a, b, c, d] = quads.quads[q];
    const Vec3 sum = quads.position(a) + quads.position(b) + quads.position(c) + quads.position(d);
    ofQuads.addBeyond(enough, sum / 4);
  }
  const double away = ofQuads.farthest() / side;
  return away < least ? 0 : away;
}

OriginalDistance::OriginalDistance(const WorkingMesh& ground)
    : ground_(ground), tree_(ground.surface().mesh(), ground.surface().positions()) {}

double OriginalDistance::farthest(const QuadMesh& quads) const {
  const QuadTree tree(quads);
  DistanceSampler toQuads(*tree), toOriginal(tree_.triangles());
  const OriginalSurface& surface = ground_.surface();
  for (Index v = 0; v < surface.mesh().vertexCapacity(); ++v)
    if (surface.mesh().isAlive(Vertex(v)))
      toQuads.addBeyond(toQuads.farthest(), surface.positions()[Vertex(v)]);
  for (Index v = 0; v < ground_.mesh().vertexCapacity(); ++v)
    if (ground_.mesh().isAlive(Vertex(v)))
      toQuads.addBeyond(toQuads.farthest(), ground_.position(Vertex(v)));
  for (Index t = 0; t < 2 * quads.quads.size(); ++t) {
    Vec3 middle = Vec3::Zero();
    const auto corners = tree.corners(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &a = quads.position(corners[i]), &b = quads.position(corners[(i + 1) % 3]);
      toOriginal.addBeyond(toOriginal.farthest(), (a + b) / 2);
      middle += a / 3;
    }
    toOriginal.addBeyond(toOriginal.farthest(), middle);
  }
  return std::max(toQuads.farthest(), toOriginal.farthest());
}

}  // namespace remesher
