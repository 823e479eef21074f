// SPDX-License-Identifier: MIT
#include "jobs/part_targets.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/error.h"
#include "geometry/triangle.h"
#include "remesh/schemes/chart_needs.h"

namespace remesher {
namespace {

// Of what a part has by area this much is left to it, however much charts of others need.
constexpr double kLeftByArea = 0.25;
// Narrower charts than this, in units of the side of a square as large as the whole, hardly show.
constexpr double kShows = 0.002;

// What a chart asks of its part.
struct Wish {
  double vertices;
  std::size_t part;
};

// How much longer lengths are in the world than in the part: the mean over its instances.
double scaleOf(const io::Part& part) {
  if (part.instances.empty()) return 1;
  double sum = 0;
  for (const Transform& place : part.instances)
    sum += std::cbrt(std::abs(place.linear().determinant()));
  return sum / double(part.instances.size());
}

// The mean over its places: however often a part is shown, its triangles shall be as large as those
// of the others.
double worldArea(const io::Part& part) {
  double sum = 0;
  for (const Transform& place : part.instances)
    sum += std::pow(std::abs(place.linear().determinant()), 2.0 / 3);
  const double perArea = part.instances.empty() ? 1 : sum / double(part.instances.size());
  double area = 0;
  for (std::size_t i = 0; i + 2 < part.mesh.indices.size(); i += 3) {
    const Vec3& a = part.mesh.positions[part.mesh.indices[i]];
    const Vec3& b = part.mesh.positions[part.mesh.indices[i + 1]];
    const Vec3& c = part.mesh.positions[part.mesh.indices[i + 2]];
    area += remesher::area(a, b, c);
  }
  return area * perArea;
}

}  // namespace

PartTargets::PartTargets(const std::vector<io::Part>& parts, const RemeshOptions& options)
    : parts_(parts), options_(options), order_(parts.size()) {
  if (parts.size() > 1 && !(options.density.empty() && options.featureEdges.empty()))
    throw Error(ErrorCode::InvalidOption,
                "density and featureEdges need a file with one mesh, not with " +
                    std::to_string(parts.size()) + ".",
                "Give the meshes one by one.");
  // One alone shares with nobody.
  for (const io::Part& part : parts) areas_.push_back(parts.size() > 1 ? worldArea(part) : 1);
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return areas_[a] < areas_[b]; });
  waiting_ = order_;
  verticesLeft_ = options.vertices ? double(*options.vertices) : 0;
  reserved_.assign(parts.size(), 0);
  if (parts.size() > 1 && options.vertices) reserveForCharts();
}

// Charts that cost least come first, as long as there are vertices to spend.
void PartTargets::reserveForCharts() {
  const double area = std::accumulate(areas_.begin(), areas_.end(), 0.0);
  std::vector<Wish> wishes;
  for (std::size_t i = 0; i < parts_.size(); ++i)
    for (const ChartNeed& need : chartNeeds(parts_[i].mesh, options_))
      if (need.width * scaleOf(parts_[i]) >= kShows * std::sqrt(area))
        wishes.push_back({std::ceil(need.vertices), i});
  if (wishes.empty()) return;
  std::stable_sort(wishes.begin(), wishes.end(),
                   [](const Wish& a, const Wish& b) { return a.vertices < b.vertices; });
  for (std::size_t i = 0; i < parts_.size(); ++i)
    reserved_[i] = kLeftByArea * areas_[i] / area * verticesLeft_;
  double free = (1 - kLeftByArea) * verticesLeft_;
  for (const auto& [vertices, part] : wishes) {
    const double more = vertices - reserved_[part];
    if (more <= 0 || more > free) continue;
    reserved_[part] = vertices;
    free -= more;
  }
}

// Of the vertices that are left, by area among those whose share is more than what is reserved.
double PartTargets::shareOf(std::size_t part) const {
  std::vector<std::size_t> byArea = waiting_;
  double vertices = verticesLeft_;
  for (;;) {
    double area = 0;
    for (const std::size_t i : byArea) area += areas_[i];
    const auto share = [&](std::size_t i) {
      return area > 0 ? std::max(0.0, areas_[i] / area * vertices) : vertices;
    };
    const auto needy = std::stable_partition(
        byArea.begin(), byArea.end(), [&](std::size_t i) { return reserved_[i] <= share(i); });
    const bool isNeedy = std::find(needy, byArea.end(), part) != byArea.end();
    if (isNeedy) return std::min(reserved_[part], verticesLeft_);
    if (needy == byArea.end()) return share(part);
    for (auto i = needy; i != byArea.end(); ++i) vertices -= reserved_[*i];
    byArea.erase(needy, byArea.end());
  }
}

RemeshOptions PartTargets::of(std::size_t part) const {
  RemeshOptions result = options_;
  const bool isLast = part == order_.back();
  // The last part has only what is left; and a whole that asks for no number asks for no fewer.
  const bool asksForNone = !options_.vertices && !options_.ratio && !options_.edgeLength;
  const bool isOneOfMany = parts_.size() > 1 && !(isLast && options_.vertices);
  if (asksForNone || isOneOfMany) result.tooFew = TooFew::Raise;
  if (options_.vertices) {
    result.vertices = Index(std::llround(isLast ? verticesLeft_ : shareOf(part)));
  }
  if (options_.edgeLength) *result.edgeLength /= scaleOf(parts_[part]);
  return result;
}

void PartTargets::given(std::size_t part, std::size_t vertices) {
  std::erase(waiting_, part);
  verticesLeft_ = std::max(0.0, verticesLeft_ - double(vertices));
}

}  // namespace remesher
