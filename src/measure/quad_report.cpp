// SPDX-License-Identifier: MIT
#include "measure/quad_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "geometry/quad.h"
#include "mesh/quad_loops.h"

namespace remesher {

namespace {

constexpr double kMost = 0.95;  // the percentile's share of the angles

// The quads by their positions; triangles 2i and 2i + 1 have the corners 0, 1, 2 and 0, 2, 3.
std::vector<std::array<Index, 4>> quadsOf(const TriangleMesh& mesh, const Welding& welding) {
  std::vector<std::array<Index, 4>> quads;
  for (std::size_t i = 0; i + 5 < mesh.indices.size(); i += 6) {
    const Index* const corners = &mesh.indices[i];
    quads.push_back({welding.first[corners[0]], welding.first[corners[1]],
                     welding.first[corners[2]], welding.first[corners[5]]});
  }
  return quads;
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
  const std::vector<std::array<Index, 4>> quads = quadsOf(mesh, welding);
  count_ += quads.size();
  const std::vector<QuadSide> sides = sidesByEdge(quads);
  irregular_ += countIrregular(mesh.positions.size(), sides);
  const QuadLoops loops = loopsOf(quads.size(), sides);
  loops_ += loops.count;
  longest_ = std::max(longest_, loops.longest);
  edges_ += loops.edges;
  selfCrossing_ += loops.selfCrossing;
  for (const std::array<Index, 4>& at : quads) {
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
