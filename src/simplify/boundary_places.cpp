// SPDX-License-Identifier: MIT
#include "simplify/boundary_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesher {

BoundaryPlaces::BoundaryPlaces(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions)
    : at_(mesh.vertexCapacity(), -1) {
  for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
    if (!mesh.isAlive(Vertex(i)) || !mesh.isBoundary(Vertex(i)) || at_[Vertex(i)] >= 0) continue;
    const Index first = Index(points_.size());
    for (Vertex v(i); at_[v] < 0; v = mesh.tip(mesh.outgoing(v))) {
      at_[v] = double(points_.size());
      points_.push_back(positions[v]);
    }
    loops_.push_back({first, Index(points_.size()) - first});
  }
}

const BoundaryPlaces::Loop& BoundaryPlaces::loopOf(double at) const {
  const auto after = std::upper_bound(loops_.begin(), loops_.end(), at,
                                      [](double a, const Loop& loop) { return a < loop.first; });
  return *std::prev(after);
}

BoundaryPlaces::Place BoundaryPlaces::best(const Quadric& quadric, const Vec3& center, Vertex from,
                                           Vertex to) const {
  const Loop& loop = loopOf(at_[from]);
  const double begin = at_[from], end = at_[to] + (at_[to] > begin ? 0 : loop.size);
  const auto point = [&](double whole) -> const Vec3& {
    return points_[loop.first + Index(whole - loop.first) % loop.size];
  };
  Place result{Vec3::Zero(), -1};
  double least = std::numeric_limits<double>::infinity();
  for (double edge = std::floor(begin); edge < end; ++edge) {
    const Vec3 &start = point(edge), way = point(edge + 1) - start;
    const double bend = way.dot(quadric.square * way);
    const double slope = way.dot(quadric.square * (start - center) + quadric.linear);
    const double low = std::max(begin - edge, 0.0), high = std::min(end - edge, 1.0);
    const double share = std::clamp(bend > 0 ? -slope / bend : low, low, high);
    const Vec3 place = share == 1 ? point(edge + 1) : Vec3(start + share * way);
    const double sum = quadric.at(place - center);
    if (result.at >= 0 && !(sum < least)) continue;
    least = sum;
    result = {place, edge + share};
  }
  if (result.at >= double(loop.first + loop.size)) result.at -= loop.size;
  return result;
}

}  // namespace remesher
