// SPDX-License-Identifier: MIT
#include "original/curves/spikes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "base/options.h"
#include "geometry/triangle.h"
#include "original/curves/shape_angles.h"

namespace remesher {

namespace {

// A spike is longer than kSlender × the way around its foot, which is shorter than kFewAround
// edges.
constexpr double kSlender = 0.5;
constexpr double kFewAround = 8;
// Tips are vertices most of whose edges are kFar × as long as the median edge.
constexpr double kFar = 4;
// The skin of a spike turns: at most half of the edges at its tips bend by less than this. Fans in
// planes, such as the sides of a box around holes, bend at few edges.
const double kStraight = std::cos(radians(1));
// On a boundary a spike must be this many times as long as all the rest is wide, because an outline
// may come to a slender point.
constexpr double kWild = 10;
// Spikes with less than this share of the area do no harm.
constexpr double kWorthAWord = 0.05;

// Sorts only the bucket that holds the median, which few lengths share.
double median(const std::vector<double>& lengths, double longest) {
  constexpr std::size_t kBuckets = 1024;
  if (!(longest > 0)) return 0;
  const double scale = (kBuckets - 1) / longest;
  const auto bucketOf = [&](double length) { return std::size_t(length * scale); };
  std::array<Index, kBuckets> counts{};
  for (const double length : lengths) ++counts[bucketOf(length)];
  std::size_t bucket = 0, rank = lengths.size() / 2;
  for (; rank >= counts[bucket]; ++bucket) rank -= counts[bucket];
  std::vector<double> own;
  own.reserve(counts[bucket]);
  for (const double length : lengths)
    if (bucketOf(length) == bucket) own.push_back(length);
  const auto middle = own.begin() + std::ptrdiff_t(rank);
  std::nth_element(own.begin(), middle, own.end());
  return *middle;
}

class Search {
 public:
  Search(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, const SpikeRules& rules)
      : mesh_(mesh), positions_(positions), rules_(rules), isFar_(mesh.vertexCapacity(), 0) {}

  Spikes run() {
    if (!markFar()) return {};
    Spikes spikes;
    spikes.lengths.assign(mesh_.vertexCapacity(), 0);
    for (Index i = 0; i < mesh_.vertexCapacity(); ++i) {
      if (!isFar_[Vertex(i)]) continue;
      const std::vector<Vertex> tips = takeTips(Vertex(i));
      const double length = lengthOf(tips);
      if (length == 0) continue;
      for (const Vertex v : tips) spikes.lengths[v] = length;
      if (!spikes.longest || length > spikes.lengths[spikes.longest]) spikes.longest = tips[0];
      ++spikes.count;
    }
    measureRest(spikes);
    findCorners(spikes);
    // If most of the vertices, before or after, would belong to spikes, the spikes are the surface
    // itself.
    const double share = 2 * double(spikes.corners.size());
    const bool isMost = share > double(mesh_.vertexCount()) || share > rules_.vertices;
    const bool isWorthIt = whole_ - spikes.restOfArea >= kWorthAWord * whole_;
    return isMost || !isWorthIt || !(spikes.restOfArea > 0) ? Spikes{} : spikes;
  }

 private:
  double distance(Vertex a, Vertex b) const {
    return remesher::distance(positions_[a], positions_[b]);
  }

  // Marks vertices most of whose edges (on a boundary all) are far longer than usual. Returns
  // whether there are any.
  bool markFar() {
    const std::vector<double> lengths = edgeLengths(mesh_, positions_);
    const double longest = *std::max_element(lengths.begin(), lengths.end());
    const double limit = kFar * median(lengths, longest);
    if (!(longest > limit)) return false;
    VertexData<int> longEdges(mesh_.vertexCapacity(), 0);
    const double* length = lengths.data();
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (!mesh_.isEdge(h) || !(*length++ > limit)) continue;
      ++longEdges[mesh_.origin(h)];
      ++longEdges[mesh_.tip(h)];
    }
    bool anyFar = false;
    for (Index i = 0; i < mesh_.vertexCapacity(); ++i) {
      const Vertex v(i);
      if (longEdges[v] == 0) continue;
      const int all = mesh_.valence(v);
      isFar_[v] = all - longEdges[v] <= (mesh_.isBoundary(v) ? 0 : all / 2);
      anyFar = anyFar || isFar_[v];
    }
    for (Index i = 0; anyFar && i < mesh_.vertexCapacity(); ++i)
      if (mesh_.isAlive(Vertex(i)) && !isFar_[Vertex(i)]) rest_.extend(positions_[Vertex(i)]);
    return anyFar;
  }

  // Takes the marked vertices connected to v; each is taken once.
  std::vector<Vertex> takeTips(Vertex v) {
    std::vector<Vertex> tips = {v};
    isFar_[v] = 0;
    for (std::size_t k = 0; k < tips.size(); ++k)
      mesh_.forEachNeighbor(tips[k], [&](Vertex w) {
        if (!isFar_[w]) return;
        isFar_[w] = 0;
        tips.push_back(w);
      });
    return tips;
  }

  // Whether the surface bends at most of the edges at the tips; at a boundary it need not.
  bool turns(const std::vector<Vertex>& tips) const {
    const auto normal = [&](Halfedge h) {
      const auto [a, b, c] = mesh_.vertices(HalfedgeMesh::face(h));
      return unitNormal(positions_[a], positions_[b], positions_[c]);
    };
    std::size_t all = 0, straight = 0;
    for (const Vertex v : tips) {
      if (mesh_.isBoundary(v)) return true;
      mesh_.forEachOutgoing(v, [&](Halfedge h) {
        ++all;
        straight += normal(h).dot(normal(mesh_.twin(h))) > kStraight;
      });
    }
    return 2 * straight <= all;
  }

  // The shortest way from the foot to the tips; 0 if the tips are no spike, or a body of their own.
  double lengthOf(const std::vector<Vertex>& tips) const {
    const std::set<Vertex> found(tips.begin(), tips.end());
    const auto isTip = [&](Vertex v) { return found.contains(v); };
    double shortest = kInfinity, around = 0;
    for (const Vertex v : tips)
      mesh_.forEachOutgoing(v, [&](Halfedge h) {
        const Vertex a = mesh_.tip(h), b = mesh_.opposite(h);
        if (!isTip(a)) shortest = std::min(shortest, distance(v, a));
        if (!isTip(a) && !isTip(b)) around += distance(a, b);
      });
    const bool isWholePart = std::isinf(shortest);
    if (isWholePart || !turns(tips)) return 0;
    const bool isOutline =
        std::any_of(tips.begin(), tips.end(), [&](Vertex v) { return mesh_.isBoundary(v); });
    const double least =
        isOutline ? kWild * (rest_.max() - rest_.min()).maxCoeff() : kSlender * around;
    return shortest > least && around < kFewAround * rules_.size ? shortest : 0;
  }

  void findCorners(Spikes& spikes) const {
    if (spikes.empty()) return;
    for (Index i = 0; i < mesh_.vertexCapacity(); ++i) {
      const Vertex v(i);
      if (!mesh_.isAlive(v)) continue;
      bool isCorner = spikes.lengths[v] > 0;
      mesh_.forEachNeighbor(v, [&](Vertex w) { isCorner = isCorner || spikes.lengths[w] > 0; });
      if (isCorner) spikes.corners.push_back(v);
    }
  }

  void measureRest(Spikes& spikes) {
    for (Index i = 0; i < mesh_.faceCapacity(); ++i) {
      if (!mesh_.isAlive(Face(i))) continue;
      const auto [a, b, c] = mesh_.vertices(Face(i));
      const double own = area(positions_[a], positions_[b], positions_[c]);
      whole_ += own;
      if (!spikes.covers(mesh_, Face(i))) spikes.restOfArea += own;
    }
  }

  const HalfedgeMesh& mesh_;
  const VertexData<Vec3>& positions_;
  const SpikeRules rules_;
  VertexData<char> isFar_;
  Eigen::AlignedBox3d rest_;  // box of the vertices that are not marked
  double whole_ = 0;
};

}  // namespace

bool Spikes::covers(const HalfedgeMesh& mesh, Face f) const {
  if (empty()) return false;
  const auto [a, b, c] = mesh.vertices(f);
  return lengths[a] > 0 || lengths[b] > 0 || lengths[c] > 0;
}

Spikes findSpikes(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                  const SpikeRules& rules) {
  return Search(mesh, positions, rules).run();
}

}  // namespace remesher
