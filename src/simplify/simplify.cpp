// SPDX-License-Identifier: MIT
#include "simplify/simplify.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/options.h"
#include "geometry/quadric.h"
#include "geometry/triangle.h"
#include "mesh/edge_queue.h"
#include "mesh/euler_operators.h"
#include "simplify/attribute_quadrics.h"

namespace remesher {

namespace {

// A distance along the surface counts as some 450th of a distance away from it, so that triangles
// on flat parts stay even.
constexpr double kSideways = 5e-6;
// Where only costs are asked for it hardly counts: just so that the places of vertices are unique.
constexpr double kUnseenSideways = 1e-10;
// The weights of edges, times their squared length: of a border, to which the two sides of a seam
// add up, and of either side of a sharp edge within the surface.
constexpr double kBorder = 2, kCrease = 0.2;
// The weight of a border whose vertices slide along it: its chords are all on one side, and so
// farther away than those of vertices that are free.
constexpr double kSlidBorder = 6;
const double kSharp = std::cos(radians(kFeatureAngle));  // between normals
// The cosine of the largest angle by which a collapse may turn a triangle, if others go.
constexpr double kTurned = 0.5;

// The key is the negative cost: the sum times √area, since a large area shows errors more.
struct Offer : RankedEdge {
  Index stamp;        // the sum of both stamps
  Vec3 place;         // of the vertex that remains
  double onLoop = 0;  // and where that is on a boundary
};

// Free: inside and on no seam. Jump: inside, on seams that are all jumps. Seam: on a seam or a
// boundary. Fixed: where these meet or end.
enum class Freedom : char { Free, Jump, Seam, Fixed };

// The bodies around a vertex, each once.
std::vector<Index> bodiesAround(const SimpleSurface& surface, Vertex v) {
  std::vector<Index> result;
  surface.mesh.forEachOutgoing(v, [&](Halfedge h) {
    const Index body = surface.bodies[HalfedgeMesh::face(h)];
    if (std::find(result.begin(), result.end(), body) == result.end()) result.push_back(body);
  });
  return result;
}

class Simplification {
 public:
  Simplification(SimpleSurface& surface, KeptAttributes* kept, double sideways = kSideways)
      : surface_(surface),
        mesh_(surface.mesh),
        kept_(kept),
        sideways_(sideways),
        quadrics_(mesh_.vertexCapacity()),
        stamps_(mesh_.vertexCapacity(), 0),
        freedom_(mesh_.vertexCapacity(), Freedom::Free) {
    for (Index i = 0; i < mesh_.vertexCapacity(); ++i)
      if (mesh_.isAlive(Vertex(i))) center_ += surface.positions[Vertex(i)];
    center_ /= double(mesh_.vertexCount());
    if (!kept && !surface.boundary) surface.boundary.emplace(mesh_, surface.positions);
    if (kept) attributes_.emplace(kept->itemSize, kept->values);
    for (Index i = 0; i < mesh_.faceCapacity(); ++i)
      if (mesh_.isAlive(Face(i))) addFace(Face(i));
    for (Index i = 0; i < mesh_.vertexCapacity(); ++i)
      if (mesh_.isAlive(Vertex(i))) freedom_[Vertex(i)] = freedomOf(Vertex(i));
    for (Index i = 0; i < surface.held.size(); ++i)
      if (surface.held[Vertex(i)]) freedom_[Vertex(i)] = Freedom::Fixed;
    for (Index i = 0; i < surface.bodies.size(); ++i)
      if (mesh_.isAlive(Face(i))) ++trianglesOf_[surface.bodies[Face(i)]];
  }

  void run(double leastTurned, std::size_t vertices) {
    leastTurned_ = leastTurned;
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) offer(Halfedge(i));
    std::size_t left = countVertices(surface_);
    while (left > vertices && !queue_.empty()) {
      const Offer offered = queue_.pop();
      if (!isCurrent(offered) || !isLegal(offered.edge) || turns(offered)) continue;
      const std::size_t fewer = countedAt(offered);
      if (fewer > left - vertices || endsBody(offered.edge)) continue;
      left -= fewer;
      costs_.push_back(costs_.empty() ? -offered.key : std::max(-offered.key, costs_.back()));
      collapse(offered);
    }
  }

  // Of the collapses so far, none below the one before.
  const std::vector<double>& costs() const { return costs_; }

  // Flips edges where the smallest angle of their two triangles grows, by more than rounding, which
  // would turn the diagonals of a square for ever. The smallest angles of the mesh only grow, so
  // that the loop ends.
  void widenAngles() {
    for (bool hasTurned = true; hasTurned;) {
      hasTurned = false;
      for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
        const Halfedge h(i);
        if (!mesh_.isAlive(h) || !mesh_.isEdge(h) || isSeam(h)) continue;
        if (!EulerOperators::canFlip(mesh_, h) || !widens(h)) continue;
        turn(h);
        hasTurned = true;
      }
    }
  }

 private:
  // Seen from the centre, so that numbers stay small wherever the model lies.
  Vec3 at(Vertex v) const { return surface_.positions[v] - center_; }

  // How often the vertex counts that goes. More than can be where the other vertex lacks one of its
  // bodies: that body would come to a place where it has not been.
  std::size_t countedAt(const Offer& offered) const {
    if (surface_.bodies.size() == 0) return 1;
    const std::vector<Index> gone = bodiesAround(surface_, offered.from),
                             there = bodiesAround(surface_, offered.to);
    const bool isThere = std::all_of(gone.begin(), gone.end(), [&](Index body) {
      return std::find(there.begin(), there.end(), body) != there.end();
    });
    return isThere ? gone.size() : std::numeric_limits<std::size_t>::max();
  }

  // Whether the triangles at an edge are all that a body has.
  bool endsBody(Halfedge h) const {
    if (surface_.bodies.size() == 0) return false;
    const Index own = surface_.bodies[HalfedgeMesh::face(h)];
    const Halfedge t = mesh_.twin(h);
    if (!t) return trianglesOf_.at(own) <= 1;
    const Index other = surface_.bodies[HalfedgeMesh::face(t)];
    if (own == other) return trianglesOf_.at(own) <= 2;
    return std::min(trianglesOf_.at(own), trianglesOf_.at(other)) <= 1;
  }

  bool isSeam(Halfedge h) const { return mesh_.isBoundary(h) || surface_.seams[h]; }

  void addFace(Face f) {
    const auto vertices = mesh_.vertices(f);
    const Vec3 a = at(vertices[0]), b = at(vertices[1]), c = at(vertices[2]);
    const Vec3 normal = unitNormal(a, b, c);
    const double own = area(a, b, c);
    for (const Vertex v : vertices) {
      quadrics_[v].addPlane(normal, a, own);
      quadrics_[v].addPoint(at(v), sideways_ * own);
      quadrics_[v].area += own;
    }
    if (attributes_) {
      const auto wedge = [&](int k) { return kept_->wedges[HalfedgeMesh::halfedge(f, k)]; };
      attributes_->addTriangle({a, b, c}, {wedge(0), wedge(1), wedge(2)});
    }
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = HalfedgeMesh::halfedge(f, k);
      if (mesh_.isBoundary(h))
        addBorder(h, normal);
      else
        addEdge(
            h, normal,
            std::max(isSeam(h) ? kBorder / 2 * worthOf(h) : 0, isSharp(h, normal) ? kCrease : 0));
    }
  }

  bool isSharp(Halfedge h, const Vec3& normal) const {
    const auto [a, b, c] = mesh_.vertices(HalfedgeMesh::face(mesh_.twin(h)));
    return unitNormal(at(a), at(b), at(c)).dot(normal) < kSharp;
  }

  // The share of its weight that a seam has: a jump that lies beside its place shows an error of as
  // much as the values differ, however far away it is.
  double worthOf(Halfedge h) const {
    if (!attributes_ || surface_.seams[h] != kJump) return 1;
    double most = 0;
    for (const Halfedge side : {h, mesh_.twin(h)}) {
      const Index across = kept_->wedges[HalfedgeMesh::next(mesh_.twin(side))];
      most = std::max(most, attributes_->squaredJump(kept_->wedges[side], across));
    }
    return std::min(1.0, most / (at(mesh_.tip(h)) - at(mesh_.origin(h))).squaredNorm());
  }

  // A border shows errors as much as the inside does: it counts as though the surface went on as
  // far as the border edge is long.
  void addBorder(Halfedge h, const Vec3& normal) {
    addEdge(h, normal, attributes_ ? kBorder : kSlidBorder);
    const double beyond = (at(mesh_.tip(h)) - at(mesh_.origin(h))).squaredNorm();
    for (const Vertex v : {mesh_.origin(h), mesh_.tip(h)}) quadrics_[v].area += beyond;
  }

  // Adds the distance from the edge within the plane of its triangle.
  void addEdge(Halfedge h, const Vec3& normal, double weight) {
    const Vec3 from = at(mesh_.origin(h)), way = at(mesh_.tip(h)) - from;
    const Vec3 outwards = way.cross(normal).stableNormalized();
    for (const Vertex v : {mesh_.origin(h), mesh_.tip(h)})
      quadrics_[v].addPlane(outwards, from, weight * way.squaredNorm());
  }

  Freedom freedomOf(Vertex v) const {
    int seams = 0;
    bool areJumps = attributes_.has_value();
    mesh_.forEachOutgoing(v, [&](Halfedge h) {
      seams += isSeam(h) ? 1 : 0;
      seams += mesh_.isBoundary(HalfedgeMesh::prev(h)) ? 1 : 0;
      areJumps &= surface_.seams[h] != kSeam;
    });
    if (seams > 0 && areJumps && !mesh_.isBoundary(v)) return Freedom::Jump;
    return seams == 0 ? Freedom::Free : seams == 2 ? Freedom::Seam : Freedom::Fixed;
  }

  static Freedom joined(Freedom gone, Freedom into) {
    if (gone == Freedom::Jump && into == Freedom::Seam) return Freedom::Fixed;
    return std::max(gone, into);
  }

  // Stamps only grow: if their sum is the same, so are both.
  bool isCurrent(const Offer& offered) const {
    const auto& [key, h, from, into] = static_cast<const RankedEdge&>(offered);
    return mesh_.isAlive(h) && mesh_.origin(h) == from && mesh_.tip(h) == into &&
           stamps_[from] + stamps_[into] == offered.stamp;
  }

  void offer(Halfedge h) {
    if (!mesh_.isAlive(h)) return;
    const Vertex from = mesh_.origin(h), into = mesh_.tip(h);
    if (freedom_[from] >= Freedom::Seam && !isSeam(h)) return;
    if (freedom_[from] == Freedom::Fixed && !attributes_) return;
    // Where a seam ends on a boundary: the boundary would lead across the surface.
    if (mesh_.isBoundary(from) && !mesh_.isBoundary(h)) return;
    Quadric sum = quadrics_[from];
    sum.add(quadrics_[into]);
    double cost = sum.at(at(into));
    Offer offered{{0, h, from, into}, stamps_[from] + stamps_[into], surface_.positions[into]};
    if (attributes_) {
      for (const auto& [going, staying] : wedgesAlong(h))
        cost += attributes_->cost(going, staying, at(into));
      for (const Index wedge : wedgesBeside(h)) cost += attributes_->cost(wedge, wedge, at(into));
    } else if (freedom_[from] == freedom_[into] && mesh_.isBoundary(h)) {
      const BoundaryPlaces::Place best = surface_.boundary->best(sum, center_, from, into);
      cost = sum.at(best.position - center_);
      offered.place = best.position;
      offered.onLoop = best.at;
    } else if (freedom_[from] == freedom_[into]) {
      const Vec3 best = sum.square.ldlt().solve(-sum.linear);
      if (sum.at(best) < cost) {
        cost = sum.at(best);
        offered.place = best + center_;
      }
    }
    offered.key = -std::max(cost, 0.0) * std::sqrt(sum.area);
    queue_.push(offered);
  }

  // The wedges at the origin and at the tip of an edge, a pair for each side; one pair if both
  // sides have the same.
  std::vector<std::pair<Index, Index>> wedgesAlong(Halfedge h) const {
    const auto& wedges = kept_->wedges;
    std::vector<std::pair<Index, Index>> pairs = {{wedges[h], wedges[HalfedgeMesh::next(h)]}};
    if (const Halfedge t = mesh_.twin(h)) {
      const std::pair<Index, Index> other(wedges[HalfedgeMesh::next(t)], wedges[t]);
      if (other != pairs.front()) pairs.push_back(other);
    }
    return pairs;
  }

  // The other wedges at the origin of an edge, where seams meet or are jumps.
  std::vector<Index> wedgesBeside(Halfedge h) const {
    std::vector<Index> result;
    const Freedom freedom = freedom_[mesh_.origin(h)];
    if (freedom != Freedom::Fixed && freedom != Freedom::Jump) return result;
    const auto pairs = wedgesAlong(h);
    mesh_.forEachOutgoing(mesh_.origin(h), [&](Halfedge corner) {
      const Index wedge = kept_->wedges[corner];
      const bool isAlong = wedge == pairs.front().first || wedge == pairs.back().first;
      if (!isAlong && std::find(result.begin(), result.end(), wedge) == result.end())
        result.push_back(wedge);
    });
    return result;
  }

  bool isLegal(Halfedge h) const {
    // A hub stays, and loses neighbours as they are merged with each other.
    if (mesh_.isHub(mesh_.origin(h)) || mesh_.isHub(mesh_.tip(h))) return false;
    if (mesh_.valence(mesh_.origin(h)) + mesh_.valence(mesh_.tip(h)) - 4 >
        HalfedgeMesh::kMostNeighbors)
      return false;
    if (!EulerOperators::canCollapse(mesh_, h)) return false;
    // Two seams of one triangle would become one. Where attributes are kept, their cost decides.
    if (attributes_) return true;
    for (const Halfedge side : {h, mesh_.twin(h)})
      if (side && isSeam(HalfedgeMesh::next(side)) && isSeam(HalfedgeMesh::prev(side)))
        return false;
    return true;
  }

  // The unit normal; zero for a triangle that single precision hardly tells from a line.
  static Vec3 facing(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    const bool isLine = area(a, b, c) <= std::numeric_limits<float>::epsilon() * longest;
    return isLine ? Vec3(Vec3::Zero()) : unitNormal(a, b, c);
  }

  // Whether a triangle that remains would turn too far or become a line.
  bool turns(const Offer& offered) const {
    const Vertex from = offered.from, into = offered.to;
    bool result = false;
    for (const Vertex moved : {from, into})
      mesh_.forEachOutgoing(moved, [&](Halfedge h) {
        const Vertex b = mesh_.tip(h), c = mesh_.opposite(h);
        if (b == from || b == into || c == from || c == into) return;
        const auto& p = surface_.positions;
        const Vec3 before = facing(p[moved], p[b], p[c]);
        const Vec3 now = facing(offered.place, p[b], p[c]);
        result |= !before.isZero() && !(before.dot(now) > leastTurned_);
      });
    return result;
  }

  void collapse(const Offer& offered) {
    const Halfedge h = offered.edge;
    const Quadric gone = quadrics_[offered.from];
    for (const Halfedge side : {h, mesh_.twin(h)}) {
      if (!side) continue;
      if (surface_.bodies.size() > 0) --trianglesOf_[surface_.bodies[HalfedgeMesh::face(side)]];
      const Halfedge second = HalfedgeMesh::next(side), third = HalfedgeMesh::prev(side);
      const char seam = std::max(surface_.seams[second], surface_.seams[third]);
      for (const Halfedge edge : {second, third})
        if (mesh_.twin(edge)) surface_.seams[mesh_.twin(edge)] = seam;
    }
    if (attributes_) mergeWedges(h);
    const bool slides =
        !attributes_ && mesh_.isBoundary(h) && freedom_[offered.to] == Freedom::Seam;
    const Vertex into = EulerOperators(surface_.mesh).collapse(h);
    surface_.positions[into] = offered.place;
    if (slides) surface_.boundary->move(into, offered.onLoop);
    quadrics_[into].add(gone);
    freedom_[into] = joined(freedom_[offered.from], freedom_[into]);
    ++stamps_[into];
    mesh_.forEachNeighbor(into, [&](Vertex w) { stamps_[w] += mesh_.isHub(w) ? 0 : 1; });
    offerAround(into);
  }

  // Before the collapse of h: the corners at its origin get the wedges at its tip on the same side.
  // Where seams meet, the other corners keep their wedge: its attributes move to the tip.
  void mergeWedges(Halfedge h) {
    const auto pairs = wedgesAlong(h);
    for (const auto& [going, staying] : pairs) attributes_->merge(going, staying);
    mesh_.forEachOutgoing(mesh_.origin(h), [&](Halfedge corner) {
      Index& wedge = kept_->wedges[corner];
      if (wedge == pairs.back().first)
        wedge = pairs.back().second;
      else if (wedge == pairs.front().first)
        wedge = pairs.front().second;
    });
  }

  // Collapses refused before may be possible now, all around. Offers at a neighbouring hub stay.
  void offerAround(Vertex v) {
    around_.clear();
    const auto gather = [&](Vertex w) {
      mesh_.forEachOutgoing(w, [&](Halfedge h) {
        around_.push_back(h);
        around_.push_back(HalfedgeMesh::prev(h));
      });
    };
    gather(v);
    mesh_.forEachNeighbor(v, [&](Vertex w) {
      if (!mesh_.isHub(w)) gather(w);
    });
    std::sort(around_.begin(), around_.end());
    around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
    for (const Halfedge h : around_) offer(h);
  }

  // Whether a flip widens the smallest angle, folds nothing, and moves the surface by no more than
  // collapses have moved it there.
  bool widens(Halfedge h) const {
    const Halfedge t = mesh_.twin(h);
    const Vertex from = mesh_.origin(h), to = mesh_.tip(h);
    const Vertex left = mesh_.opposite(h), right = mesh_.opposite(t);
    const Vec3 a = at(from), b = at(to), c = at(left), d = at(right);
    const double before = std::min(minAngle(a, b, c), minAngle(b, a, d));
    const double after = std::min(minAngle(a, d, c), minAngle(b, c, d));
    if (!(after > before + std::numeric_limits<float>::epsilon())) return false;
    const Vec3 first = unitNormal(a, d, c), second = unitNormal(b, c, d);
    for (const Vec3& old : {unitNormal(a, b, c), unitNormal(b, a, d)})
      if (!old.isZero() && !(std::min(old.dot(first), old.dot(second)) > kTurned)) return false;
    const Vec3 across = (b - a).cross(d - c).stableNormalized();
    const double height = across.dot(c - a);
    double cost = 0;
    for (const Vertex v : {from, to, left, right}) cost += quadrics_[v].at(at(v)) / 4;
    return height * height * (area(a, b, c) + area(b, a, d)) <= std::max(cost, 0.0);
  }

  void turn(Halfedge h) {
    const Halfedge t = mesh_.twin(h);
    auto& seams = surface_.seams;
    const char before = seams[mesh_.prev(h)], after = seams[mesh_.prev(t)];
    EulerOperators(surface_.mesh).flip(h);
    seams[h] = after;
    seams[t] = before;
    seams[mesh_.prev(h)] = seams[mesh_.prev(t)] = 0;
  }

  SimpleSurface& surface_;
  const HalfedgeMesh& mesh_;
  KeptAttributes* kept_;
  double sideways_;
  std::optional<AttributeQuadrics> attributes_;
  double leastTurned_ = kTurned;
  Vec3 center_ = Vec3::Zero();
  VertexData<Quadric> quadrics_;
  VertexData<Index> stamps_;
  VertexData<Freedom> freedom_;
  EdgeHeap<Offer> queue_;
  std::vector<Halfedge> around_;
  std::vector<double> costs_;
  std::map<Index, std::size_t> trianglesOf_;  // per body
};

}  // namespace

std::size_t countVertices(const SimpleSurface& surface) {
  if (surface.bodies.size() == 0) return surface.mesh.vertexCount();
  std::size_t count = 0;
  for (Index i = 0; i < surface.mesh.vertexCapacity(); ++i)
    if (surface.mesh.isAlive(Vertex(i))) count += bodiesAround(surface, Vertex(i)).size();
  return count;
}

void simplify(SimpleSurface& surface, std::size_t vertices, KeptAttributes* kept) {
  Simplification simplification(surface, kept);
  simplification.run(kTurned, vertices);
  simplification.run(0, vertices);  // 90°
  if (kept == nullptr) simplification.widenAngles();
}

std::vector<double> collapseCosts(SimpleSurface& surface, KeptAttributes* kept) {
  Simplification simplification(surface, kept, kUnseenSideways);
  simplification.run(kTurned, 0);
  simplification.run(0, 0);
  return simplification.costs();
}

}  // namespace remesher
