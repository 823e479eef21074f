// SPDX-License-Identifier: MIT
#include "measure/quad_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

// Counts interior vertices whose valence is not 4.
std::size_t countIrregular(const TriangleMesh& mesh, const Welding& welding) {
  const std::size_t places = mesh.positions.size();
  std::vector<std::pair<Index, Index>> sides;
  for (std::size_t q = 0; q < mesh.triangleCount() / 2; ++q) {
    const std::array<Index, 4> corners = placesOf(mesh, welding, q);
    for (std::size_t i = 0; i < 4; ++i)
      sides.emplace_back(std::minmax(corners[i], corners[(i + 1) % 4]));
  }
  std::sort(sides.begin(), sides.end());
  std::vector<int> valence(places, 0);
  std::vector<char> isBoundary(places, 0);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && sides[end] == sides[i];) ++end;
    for (const Index v : {sides[i].first, sides[i].second}) {
      ++valence[v];
      isBoundary[v] |= char(end == i + 1);
    }
  }
  std::size_t count = 0;
  for (std::size_t v = 0; v < places; ++v)
    count += valence[v] > 0 && !isBoundary[v] && valence[v] != 4;
  return count;
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

double deviationFrom90(const Vec3& out, const Vec3& in) {
  return std::abs(degrees(std::atan2(out.cross(in).norm(), out.dot(in))) - 90);
}

}  // namespace

void QuadStatistics::add(const TriangleMesh& mesh, const Welding& welding) {
  const std::size_t quads = mesh.triangleCount() / 2;
  count_ += quads;
  irregular_ += countIrregular(mesh, welding);
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
          variation(lengths_)};
}

}  // namespace remesher
