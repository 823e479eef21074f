// SPDX-License-Identifier: MIT
#include "measure/quad_report.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/disjoint_sets.h"
#include "geometry/quad.h"

namespace remesher {

namespace {

constexpr double kMost = 0.95;  // the percentile's share of the angles

// The places of a quad's corners; triangles 2i and 2i + 1 have its corners 0, 1, 2 and 0, 2, 3.
std::array<Index, 4> placesOf(const TriangleMesh& mesh, const Welding& welding, std::size_t quad) {
  const Index* const corners = &mesh.indices[6 * quad];
  return {welding.first[corners[0]], welding.first[corners[1]], welding.first[corners[2]],
          welding.first[corners[5]]};
}

// A side of a quad between two places, the lower first.
struct Side {
  std::pair<Index, Index> ends;
  Index quad, corner;
};

// All sides, those between the same places in a row.
std::vector<Side> sidesOf(const TriangleMesh& mesh, const Welding& welding) {
  std::vector<Side> sides;
  for (Index q = 0; q < mesh.triangleCount() / 2; ++q) {
    const std::array<Index, 4> corners = placesOf(mesh, welding, q);
    for (Index i = 0; i < 4; ++i)
      sides.push_back({std::minmax(corners[i], corners[(i + 1) % 4]), q, i});
  }
  std::stable_sort(sides.begin(), sides.end(),
                   [](const Side& a, const Side& b) { return a.ends < b.ends; });
  return sides;
}

template <class Visit>
void forEachEdge(const std::vector<Side>& sides, Visit visit) {
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && sides[end].ends == sides[i].ends;) ++end;
    visit(std::span(sides).subspan(i, end - i));
  }
}

// Counts interior vertices whose valence is not 4.
std::size_t countIrregular(std::size_t places, const std::vector<Side>& sides) {
  std::vector<int> valence(places, 0);
  std::vector<char> isBoundary(places, 0);
  forEachEdge(sides, [&](std::span<const Side> edge) {
    for (const Index v : {edge.front().ends.first, edge.front().ends.second}) {
      ++valence[v];
      isBoundary[v] |= char(edge.size() == 1);
    }
  });
  std::size_t count = 0;
  for (std::size_t v = 0; v < places; ++v)
    count += valence[v] > 0 && !isBoundary[v] && valence[v] != 4;
  return count;
}

// Loops of quads: each quad lies on two, one across sides 0 and 2, one across sides 1 and 3.
struct LoopCounts {
  std::size_t count = 0, longest = 0, edges = 0, selfCrossing = 0;
};

LoopCounts countLoops(std::size_t quads, const std::vector<Side>& sides) {
  DisjointSets loops(2 * quads);
  const auto loopAt = [](const Side& side) { return 2 * side.quad + side.corner % 2; };
  forEachEdge(sides, [&](std::span<const Side> edge) {
    if (edge.size() == 2) loops.unite(loopAt(edge[0]), loopAt(edge[1]));
  });
  LoopCounts counts;
  std::vector<std::size_t> crossed(2 * quads, 0);
  forEachEdge(sides, [&](std::span<const Side> edge) {
    ++counts.edges;
    counts.longest = std::max(counts.longest, ++crossed[loops.find(loopAt(edge.front()))]);
  });
  for (Index i = 0; i < 2 * quads; ++i) counts.count += loops.find(i) == i;
  for (Index q = 0; q < quads; ++q)
    counts.selfCrossing += loops.find(2 * q) == loops.find(2 * q + 1);
  return counts;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / double(values.size());
}

// The standard deviation divided by the mean.
double variation(const std::vector<double>& values) {
  const double middle = mean(values);
  double squares = 0;
  for (const double value : values) squares += (value - middle) * (value - middle);
  return middle > 0 ? std::sqrt(squares / double(values.size())) / middle : 0;
}

double share(std::size_t some, std::size_t all) { return 100 * double(some) / double(all); }

double deviationFrom90(const Vec3& out, const Vec3& in) {
  return std::abs(degrees(std::atan2(out.cross(in).norm(), out.dot(in))) - 90);
}

}  // namespace

void QuadStatistics::add(const TriangleMesh& mesh, const Welding& welding) {
  const std::size_t quads = mesh.triangleCount() / 2;
  count_ += quads;
  const std::vector<Side> sides = sidesOf(mesh, welding);
  irregular_ += countIrregular(mesh.positions.size(), sides);
  const LoopCounts loops = countLoops(quads, sides);
  loops_ += loops.count;
  longest_ = std::max(longest_, loops.longest);
  edges_ += loops.edges;
  selfCrossing_ += loops.selfCrossing;
  for (std::size_t q = 0; q < quads; ++q) {
    const std::array<Index, 4> at = placesOf(mesh, welding, q);
    const Quad corners = {mesh.positions[at[0]], mesh.positions[at[1]], mesh.positions[at[2]],
                          mesh.positions[at[3]]};
    worstSines_.push_back(leastSine(corners));
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 out = corners[(i + 1) % 4] - corners[i];
      deviations_.push_back(deviationFrom90(out, corners[(i + 3) % 4] - corners[i]));
      lengths_.push_back(out.norm());
    }
  }
}

QuadReport QuadStatistics::report() const {
  if (count_ == 0) return {};
  std::vector<double> sorted = deviations_;
  std::sort(sorted.begin(), sorted.end());
  const double p95 = sorted[std::size_t(kMost * double(sorted.size() - 1))];
  return {count_,
          irregular_,
          {mean(deviations_), p95, sorted.back()},
          {*std::min_element(worstSines_.begin(), worstSines_.end()), mean(worstSines_)},
          variation(lengths_),
          0,
          {loops_, share(longest_, edges_), share(selfCrossing_, count_)}};
}

}  // namespace remesher
