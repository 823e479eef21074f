// SPDX-License-Identifier: MIT
#include "schemes/follow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/mesh_tree.h"
#include "geometry/triangle.h"
#include "steps/simplify.h"

namespace remesher {

namespace {

constexpr std::size_t kMostThinned = 16;
// Of the diagonal: half a pixel in a picture a thousand pixels wide.
constexpr double kSeen = 5e-4;
constexpr double kMuchNearer = 2;

// The root of the mean square, over the original's area, of the distance to a mesh: four points to
// a triangle, for its corners are where vertices may have stayed.
double distanceTo(const WorkingMesh& mesh, const OriginalSurface& surface) {
  constexpr double kFar = 2.0 / 3, kNear = 1.0 / 6, kMiddle = 1.0 / 3;
  const std::array<Vec3, 4> weights = {Vec3(kMiddle, kMiddle, kMiddle), Vec3(kFar, kNear, kNear),
                                       Vec3(kNear, kFar, kNear), Vec3(kNear, kNear, kFar)};
  const MeshTree tree(mesh.mesh(), mesh.positions());
  double sum = 0, total = 0;
  for (Index f = 0; f < surface.mesh().faceCapacity(); ++f) {
    const auto [a, b, c] = surface.mesh().vertices(Face(f));
    const auto& p = surface.positions();
    const double share = area(p[a], p[b], p[c]) / double(weights.size());
    for (const Vec3& w : weights) {
      const double distance = tree.nearest(w[0] * p[a] + w[1] * p[b] + w[2] * p[c]).distance;
      sum += share * distance * distance;
      total += share;
    }
  }
  return total > 0 ? std::sqrt(sum / total) : 0;
}

}  // namespace

std::size_t distinctPositions(const WorkingMesh& mesh) {
  std::vector<std::array<double, 3>> places;
  for (Index i = 0; i < mesh.mesh().vertexCapacity(); ++i)
    if (mesh.mesh().isAlive(Vertex(i))) {
      const Vec3& p = mesh.position(Vertex(i));
      places.push_back({p.x(), p.y(), p.z()});
    }
  std::sort(places.begin(), places.end());
  return std::size_t(std::unique(places.begin(), places.end()) - places.begin());
}

std::optional<WorkingMesh> follow(const OriginalSurface& surface, const FidelityRule& rule,
                                  std::size_t positions) {
  if (surface.mesh().vertexCount() > kMostThinned * positions) return {};
  WorkingMesh mesh(surface);
  std::size_t now = distinctPositions(mesh);
  if (now <= positions) return {};
  // A collapse takes one place at most: where others share it, none.
  while (now > positions) {
    const std::size_t before = mesh.mesh().vertexCount();
    simplify(mesh, rule, before - (now - positions));
    if (mesh.mesh().vertexCount() == before) return {};
    now = distinctPositions(mesh);
  }
  return mesh;
}

bool isMuchNearer(const OriginalSurface& surface, const WorkingMesh& other,
                  const WorkingMesh& even) {
  const double distance = distanceTo(even, surface);
  return distance > kSeen * surface.diagonal() &&
         distance > kMuchNearer * distanceTo(other, surface);
}

}  // namespace remesher
