// SPDX-License-Identifier: MIT
#include "steps/simplify.h"

#include <algorithm>
#include <queue>
#include <vector>

#include "geometry/triangle.h"
#include "operators/local_operators.h"

namespace remesher {

namespace {

// A way along the surface counts as a thirtieth of one away from it: on what is flat triangles stay
// even.
constexpr double kSideways = 1e-3;
// The cosine of what a triangle may turn by at once: 75°, and 90° where nothing else goes.
constexpr double kTurned = 0.25, kFarTurned = 0;

// The sum of weighted squared distances from planes and points, as a function of the place.
struct Quadric {
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  Vec3 linear = Vec3::Zero();
  double constant = 0;

  void addPlane(const Vec3& normal, const Vec3& point, double weight) {
    const double offset = -normal.dot(point);
    square += weight * normal * normal.transpose();
    linear += weight * offset * normal;
    constant += weight * offset * offset;
  }

  void addPoint(const Vec3& point, double weight) {
    square += weight * Eigen::Matrix3d::Identity();
    linear -= weight * point;
    constant += weight * point.squaredNorm();
  }

  void add(const Quadric& other) {
    square += other.square;
    linear += other.linear;
    constant += other.constant;
  }

  double at(const Vec3& p) const { return p.dot(square * p) + 2 * linear.dot(p) + constant; }
};

struct Offer {
  double cost;
  Halfedge halfedge;
  Index stamp;  // of both ends

  // The cheapest comes out of the queue first.
  bool operator<(const Offer& other) const {
    return cost != other.cost ? cost > other.cost : halfedge > other.halfedge;
  }
};

class Simplification {
 public:
  explicit Simplification(WorkingMesh& mesh)
      : working_(mesh),
        mesh_(mesh.mesh()),
        quadrics_(mesh_.vertexCapacity()),
        stamps_(mesh_.vertexCapacity(), 0) {
    for (Index i = 0; i < mesh_.vertexCapacity(); ++i)
      if (mesh_.isAlive(Vertex(i))) center_ += mesh.position(Vertex(i));
    center_ /= double(mesh_.vertexCount());
    for (Index i = 0; i < mesh_.faceCapacity(); ++i)
      if (mesh_.isAlive(Face(i))) addFace(Face(i));
  }

  void run(const FidelityRule& rule, double leastTurned, std::size_t vertices) {
    rule_ = rule;
    leastTurned_ = leastTurned;
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) offer(Halfedge(i));
    while (mesh_.vertexCount() > vertices && !queue_.empty()) {
      const Offer offered = queue_.top();
      queue_.pop();
      if (isCurrent(offered)) collapse(offered.halfedge);
    }
  }

 private:
  // Numbers stay small wherever the model lies.
  Vec3 at(Vertex v) const { return working_.position(v) - center_; }

  void addFace(Face f) {
    const auto vertices = mesh_.vertices(f);
    const Vec3 a = at(vertices[0]), b = at(vertices[1]), c = at(vertices[2]);
    const Vec3 normal = unitNormal(a, b, c);
    const double own = area(a, b, c);
    for (const Vertex v : vertices) {
      quadrics_[v].addPlane(normal, a, own);
      quadrics_[v].addPoint(at(v), kSideways * own);
    }
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = HalfedgeMesh::halfedge(f, k);
      if (mesh_.isBoundary(h)) addBoundary(h, normal);
    }
  }

  void addBoundary(Halfedge h, const Vec3& normal) {
    const Vec3 from = at(mesh_.origin(h)), way = at(mesh_.tip(h)) - from;
    const Vec3 outwards = way.cross(normal).stableNormalized();
    for (const Vertex v : {mesh_.origin(h), mesh_.tip(h)})
      quadrics_[v].addPlane(outwards, from, way.squaredNorm());
  }

  // Stamps only grow: where the sum is the same, so are both.
  Index stampOf(Halfedge h) const { return stamps_[mesh_.origin(h)] + stamps_[mesh_.tip(h)]; }

  bool isCurrent(const Offer& offered) const {
    return mesh_.isAlive(offered.halfedge) && stampOf(offered.halfedge) == offered.stamp;
  }

  void offer(Halfedge h) {
    if (!mesh_.isAlive(h)) return;
    Quadric sum = quadrics_[mesh_.origin(h)];
    sum.add(quadrics_[mesh_.tip(h)]);
    queue_.push({sum.at(at(mesh_.tip(h))), h, stampOf(h)});
  }

  void collapse(Halfedge h) {
    const Vertex from = mesh_.origin(h);
    if (!proposeCollapseInto(working_, h, change_) || turns()) return;
    if (judge(working_, change_, rule_) != Verdict::Accepted) return;
    const Quadric gone = quadrics_[from];
    const Vertex into = apply(working_, change_);
    quadrics_[into].add(gone);
    ++stamps_[into];
    mesh_.forEachNeighbor(into, [&](Vertex w) { ++stamps_[w]; });
    offerAround(into);
  }

  bool turns() const {
    for (std::size_t i = 0; i < change_.coming.size(); ++i) {
      const auto [a, b, c] = working_.corners(change_.going[i]);
      const Vec3 before = unitNormal(a, b, c);
      const auto after = [&](int k) {
        return positionAfter(working_, change_, change_.coming[i][std::size_t(k)]);
      };
      const Vec3 now = unitNormal(after(0), after(1), after(2));
      if (!before.isZero() && !(before.dot(now) > leastTurned_)) return true;
    }
    return false;
  }

  // What was refused may be possible now, all around.
  void offerAround(Vertex v) {
    around_.clear();
    const auto gather = [&](Vertex w) {
      mesh_.forEachOutgoing(w, [&](Halfedge h) {
        around_.push_back(h);
        around_.push_back(HalfedgeMesh::prev(h));
      });
    };
    gather(v);
    mesh_.forEachNeighbor(v, gather);
    std::sort(around_.begin(), around_.end());
    around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
    for (const Halfedge h : around_) offer(h);
  }

  WorkingMesh& working_;
  const HalfedgeMesh& mesh_;
  FidelityRule rule_;
  double leastTurned_ = kTurned;
  Vec3 center_ = Vec3::Zero();
  VertexData<Quadric> quadrics_;
  VertexData<Index> stamps_;
  std::priority_queue<Offer> queue_;
  std::vector<Halfedge> around_;
  LocalChange change_;
};

}  // namespace

void simplify(WorkingMesh& mesh, const FidelityRule& rule, std::size_t vertices) {
  Simplification simplification(mesh);
  simplification.run(rule, kTurned, vertices);
  FidelityRule lenient = rule;
  lenient.fold = kTightFold;
  simplification.run(lenient, kFarTurned, vertices);
  mesh.compact();
}

}  // namespace remesher
