// SPDX-License-Identifier: MIT
#include "original/curves/feature_detection.h"

#include <algorithm>
#include <cmath>

#include "original/curves/shape_angles.h"

namespace remesher {

namespace {

// Sharp edges of machine parts are far sharper than their surroundings; those of scans, and of
// needles that repair leaves, are not. Where the whole network is sharper than this ratio, open
// networks count as features, too; else only closed ones, for those of scans have loose ends.
constexpr double kMuchSharper = 20;
// Target edge lengths.
constexpr double kLongEnough = 3;
// A fading crease is followed from its sharp part as long as it has this share of the angle and
// does not turn back.
constexpr double kFaded = 0.25;
constexpr double kTipAngle = radians(60);

// A connected set of sharp edges.
struct Network {
  std::vector<Halfedge> edges;
  double length = 0;
  double sharpness = 0;  // sum of the dihedral angles
  double beside = 0;     // the same sum over the other edges of their faces
  std::size_t besides = 0;
  std::vector<Halfedge> ends;  // halfedges that lead to the loose ends
};

class Detection {
 public:
  Detection(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, const FeatureRules& rules)
      : mesh_(mesh),
        positions_(positions),
        angle_(radians(rules.angle)),
        size_(rules.size),
        normals_(faceNormals(mesh, positions)),
        sharp_(sharpEdges(mesh, normals_, angle_)),
        visited_(mesh.vertexCapacity(), 0) {}

  std::vector<Halfedge> run() {
    Network whole;
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i)
      if (isSharp(Halfedge(i)) && Halfedge(i) < mesh_.twin(Halfedge(i)))
        addEdge(whole, Halfedge(i));
    isPart_ = isMuchSharper(whole);
    std::vector<Halfedge> features, ends;
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (!isSharp(h) || visited_[mesh_.origin(h)]) continue;
      const Network network = collect(mesh_.origin(h));
      if (!isFeature(network)) continue;
      features.insert(features.end(), network.edges.begin(), network.edges.end());
      if (isMuchSharper(network)) ends.insert(ends.end(), network.ends.begin(), network.ends.end());
    }
    for (const Halfedge end : ends) follow(end, features);
    return features;
  }

 private:
  double dihedral(Halfedge h) const { return dihedralAngle(mesh_, normals_, h); }
  bool isSharp(Halfedge h) const { return sharp_[h]; }

  Network collect(Vertex start) {
    Network network;
    std::vector<Vertex> stack = {start};
    visited_[start] = 1;
    while (!stack.empty()) {
      const Vertex v = stack.back();
      stack.pop_back();
      std::size_t degree = 0;
      Halfedge sharp;
      mesh_.forEachOutgoing(v, [&](Halfedge h) {
        if (!isSharp(h)) return;
        ++degree;
        sharp = h;
        if (h < mesh_.twin(h)) addEdge(network, h);
        if (visited_[mesh_.tip(h)]) return;
        visited_[mesh_.tip(h)] = 1;
        stack.push_back(mesh_.tip(h));
      });
      // A sharp edge that ends at a boundary has no loose end there.
      if (degree == 1 && !mesh_.isBoundary(v)) network.ends.push_back(mesh_.twin(sharp));
    }
    return network;
  }

  void addEdge(Network& network, Halfedge h) const {
    network.edges.push_back(h);
    network.length += (positions_[mesh_.tip(h)] - positions_[mesh_.origin(h)]).norm();
    network.sharpness += dihedral(h);
    for (const Halfedge side : {h, mesh_.twin(h)})
      for (const Halfedge other : {mesh_.next(side), mesh_.prev(side)}) {
        if (isSharp(other) || mesh_.isBoundary(other)) continue;
        network.beside += dihedral(other);
        ++network.besides;
      }
  }

  static bool isMuchSharper(const Network& network) {
    const double own = network.sharpness / double(network.edges.size());
    const double beside = network.besides ? network.beside / double(network.besides) : 0;
    return own >= kMuchSharper * beside;
  }

  bool isFeature(const Network& network) const {
    if (network.length < kLongEnough * size_) return false;
    if (isPart_ || isMuchSharper(network)) return true;
    // A ring of three edges is the rim of one odd triangle.
    return network.edges.size() > 3 && network.ends.empty();
  }

  // Extends a feature from a loose end until the crease has faded or meets another.
  void follow(Halfedge last, std::vector<Halfedge>& features) {
    while (const Halfedge next = continuation(last)) {
      features.push_back(next);
      last = next;
      if (visited_[mesh_.tip(next)]) return;
      visited_[mesh_.tip(next)] = 1;
    }
  }

  Halfedge continuation(Halfedge last) const {
    const Vec3 way = direction(last);
    Halfedge best;
    mesh_.forEachOutgoing(mesh_.tip(last), [&](Halfedge h) {
      if (mesh_.isBoundary(h) || mesh_.tip(h) == mesh_.origin(last)) return;
      if (direction(h).dot(way) < 0 || dihedral(h) < kFaded * angle_) return;
      if (!best || dihedral(h) > dihedral(best)) best = h;
    });
    return best;
  }

  Vec3 direction(Halfedge h) const {
    return (positions_[mesh_.tip(h)] - positions_[mesh_.origin(h)]).normalized();
  }

  const HalfedgeMesh& mesh_;
  const VertexData<Vec3>& positions_;
  double angle_;
  double size_;
  FaceData<Vec3> normals_;
  HalfedgeData<char> sharp_;
  VertexData<char> visited_;
  bool isPart_ = false;  // see kMuchSharper
};

}  // namespace

std::vector<Vertex> detectTips(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                               const std::vector<Halfedge>& features) {
  VertexData<char> isOnFeature(mesh.vertexCapacity(), 0);
  for (const Halfedge h : features) isOnFeature[mesh.origin(h)] = isOnFeature[mesh.tip(h)] = 1;
  // Along features a missing angle is normal and does not count.
  const auto missingAt = [&](Vertex v) {
    return isOnFeature[v] ? 0 : missingAngle(mesh, positions, v);
  };
  const VertexData<char> mayBeTip = mayMiss(mesh, positions, kTipAngle);
  std::vector<Vertex> tips;
  for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
    const Vertex v(i);
    if (!mayBeTip[v]) continue;
    const double missing = missingAt(v);
    if (missing < kTipAngle) continue;
    double beside = 0;
    const int valence = mesh.valence(v);
    mesh.forEachNeighbor(v, [&](Vertex w) { beside += std::abs(missingAt(w)) / valence; });
    if (missing >= kMuchSharper * beside) tips.push_back(v);
  }
  return tips;
}

std::vector<Halfedge> detectFeatures(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                                     const FeatureRules& rules) {
  return Detection(mesh, positions, rules).run();
}

}  // namespace remesher
