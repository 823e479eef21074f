// SPDX-License-Identifier: MIT
#include "remesh/quads/pair/box_quads.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "geometry/triangle_tree.h"
#include "original/surface/surface_walk.h"
#include "remesh/quads/mesh/quad_check.h"

namespace remesher {

namespace {

// Along each axis of a box.
using Steps = std::array<Index, 3>;

// A box along the main axes of a body's vertices.
struct Box3 {
  Eigen::Matrix3d axes;  // in columns, right-handed
  Vec3 low, high;        // along these
};

Box3 boxOf(const WorkingMesh& part) {
  const auto& places = part.positions().values();
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : places) middle += p / double(places.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : places) spread += (p - middle) * (p - middle).transpose();
  Box3 box{Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors(),
           Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  if (box.axes.determinant() < 0) box.axes.col(0) = -box.axes.col(0);
  for (const Vec3& p : places) {
    box.low = box.low.cwiseMin(box.axes.transpose() * p);
    box.high = box.high.cwiseMax(box.axes.transpose() * p);
  }
  return box;
}

// The vertices farthest towards the corners of the box; corner i is high along axis k where bit k
// of i is set.
std::array<Vertex, 8> farthestVertices(const WorkingMesh& part, const Box3& box) {
  std::array<Vertex, 8> corners{};
  const Vec3 extent = (box.high - box.low).cwiseMax(Vec3::Constant(1e-300));
  for (unsigned i = 0; i < corners.size(); ++i) {
    Vec3 way;
    for (unsigned k = 0; k < 3; ++k)
      way[Eigen::Index(k)] = ((i >> k & 1U) != 0 ? 1 : -1) / extent[Eigen::Index(k)];
    const Vec3 direction = box.axes * way;
    double farthest = -kInfinity;
    for (Index v = 0; v < part.mesh().vertexCapacity(); ++v) {
      const double reach = direction.dot(part.position(Vertex(v)));
      if (!(reach > farthest)) continue;
      farthest = reach;
      corners[i] = Vertex(v);
    }
  }
  return corners;
}

double countOf(const Vec3& counts) {
  return 2 * (counts[0] * counts[1] + counts[1] * counts[2] + counts[2] * counts[0]) + 2;
}

// As many steps along each axis as sides are long, so that there are about so many vertices.
Steps stepsFor(const Box3& box, double vertices) {
  const Vec3 extent = box.high - box.low;
  Vec3 best = Vec3::Ones();
  for (double parts = 1; parts <= vertices; ++parts) {
    const Vec3 counts = (parts * extent / extent.maxCoeff()).array().round().max(1.0).matrix();
    if (std::abs(countOf(counts) - vertices) < std::abs(countOf(best) - vertices)) best = counts;
  }
  return {Index(best[0]), Index(best[1]), Index(best[2])};
}

class BoxQuads {
 public:
  BoxQuads(const WorkingMesh& part, const std::array<Vertex, 8>& corners, const Steps& steps)
      : part_(part),
        corners_(corners),
        steps_(steps),
        triangles_(part.mesh().triangles()),
        tree_(part.positions().values(), triangles_) {}

  QuadMesh run() {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const Index end : {Index(0), steps_[axis]}) addSide(axis, end);
    return std::move(mesh_);
  }

 private:
  void addSide(std::size_t axis, Index end) {
    const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (Index i = 0; i < steps_[a]; ++i)
      for (Index j = 0; j < steps_[b]; ++j) {
        Four<Index> quad{};
        for (std::size_t k = 0; k < 4; ++k) {
          Steps at{};
          at[axis] = end;
          at[a] = i + (k == 1 || k == 2 ? 1 : 0);
          at[b] = j + (k >= 2 ? 1 : 0);
          quad[k] = vertexAt(at);
        }
        if (end == 0) std::swap(quad[1], quad[3]);  // outward
        mesh_.quads.push_back(quad);
        mesh_.curves.push_back({kNone, kNone, kNone, kNone});
      }
  }

  Index vertexAt(const Steps& at) {
    const auto [entry, isNew] = numbers_.emplace(at, Index(mesh_.vertices.size()));
    if (isNew) mesh_.vertices.push_back(placeAt(at));
    return entry->second;
  }

  // Between the corners, then on the surface.
  Placement placeAt(const Steps& at) const {
    Vec3 p = Vec3::Zero();
    for (unsigned i = 0; i < corners_.size(); ++i) {
      double share = 1;
      for (unsigned k = 0; k < 3; ++k) {
        const double high = double(at[k]) / double(steps_[k]);
        share *= (i >> k & 1U) != 0 ? high : 1 - high;
      }
      if (share == 1) return part_.placement(corners_[i]);
      p += share * part_.position(corners_[i]);
    }
    const Face face(tree_.nearest(p).triangle);
    const SurfacePoint start = part_.cornerPoint(HalfedgeMesh::halfedge(face));
    return part_.onSurface(closestPointFrom(part_.surface(), start, p));
  }

  const WorkingMesh& part_;
  const std::array<Vertex, 8>& corners_;
  const Steps& steps_;
  const std::vector<Index> triangles_;
  const TriangleTree tree_;
  std::map<Steps, Index> numbers_;
  QuadMesh mesh_;
};

}  // namespace

QuadMesh boxQuads(const WorkingMesh& part, double vertices) {
  if (kindOf(part.mesh()) != SurfaceKind{2, 1, 0}) return {};
  const Box3 box = boxOf(part);
  const std::array<Vertex, 8> corners = farthestVertices(part, box);
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (corners[i] == corners[k]) return {};
  return BoxQuads(part, corners, stepsFor(box, vertices)).run();
}

}  // namespace remesher
