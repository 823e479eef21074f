// SPDX-License-Identifier: MIT
#include "remesh/symmetry/mirrored_edges.h"

#include <algorithm>
#include <limits>

#include "geometry/triangle.h"

namespace remesher {

MirroredEdges::MirroredEdges(const BuiltMesh& built, double tolerance)
    : built_(built), tolerance_(tolerance) {
  for (Index v = 0; v < built.mesh.vertexCapacity(); ++v)
    byX_.emplace(built.positions[Vertex(v)].x(), Vertex(v));
}

void MirroredEdges::add(const std::vector<Halfedge>& edges) {
  for (const Halfedge h : edges)
    given_.insert(std::minmax(built_.mesh.origin(h).index, built_.mesh.tip(h).index));
  edges_.insert(given_.begin(), given_.end());
}

Vertex MirroredEdges::vertexNear(const Vec3& p) const {
  Vertex nearest;
  double least = tolerance_;
  for (auto i = byX_.lower_bound(p.x() - tolerance_);
       i != byX_.end() && i->first <= p.x() + tolerance_; ++i) {
    const double off = distance(built_.positions[i->second], p);
    if (off > least) continue;
    nearest = i->second;
    least = off;
  }
  return nearest;
}

bool MirroredEdges::isEdge(Vertex a, Vertex b) const {
  return a && b && (built_.mesh.find(a, b) || built_.mesh.find(b, a));
}

bool MirroredEdges::isOnGiven(const Vec3& p) {
  if (!tree_) {
    for (const auto& [a, b] : given_) lines_.insert(lines_.end(), {a, b, b});
    tree_.emplace(built_.positions.values(), lines_);
  }
  return tree_->nearest(p).squaredDistance <= tolerance_ * tolerance_;
}

bool MirroredEdges::addImages(const MirrorPlane& plane) {
  std::map<Index, Vertex> imageOf;
  const auto image = [&](Index v) {
    const auto [known, isNew] = imageOf.try_emplace(v);
    if (isNew) known->second = vertexNear(plane.mirrored(built_.positions[Vertex(v)]));
    return known->second;
  };
  std::set<VertexPair> images;
  for (const auto& [a, b] : edges_) {
    const Vec3 middle = (built_.positions[Vertex(a)] + built_.positions[Vertex(b)]) / 2;
    if (isEdge(image(a), image(b)))
      images.insert(std::minmax(image(a).index, image(b).index));
    else if (!isOnGiven(plane.mirrored(middle)))
      return false;
  }
  edges_.insert(images.begin(), images.end());
  return true;
}

std::vector<VertexPair> MirroredEdges::images() const {
  std::vector<VertexPair> images;
  for (const auto& [a, b] : edges_)
    if (given_.count({a, b}) == 0)
      images.emplace_back(built_.sources[Vertex(a)], built_.sources[Vertex(b)]);
  return images;
}

}  // namespace remesher
