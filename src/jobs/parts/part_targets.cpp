// SPDX-License-Identifier: MIT
#include "jobs/parts/part_targets.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string>

#include "base/error.h"
#include "base/legible.h"
#include "base/place.h"
#include "geometry/triangle.h"
#include "remesh/schemes/chart_needs.h"

namespace remesher {
namespace {

// A part keeps at least this much of its share by area, however much the charts of others need.
constexpr double kLeftByArea = 0.25;
// Charts narrower than this hardly show; unit: the side of a square with the area of the whole.
constexpr double kShows = 0.002;

// The vertices that a chart needs of its part.
struct Wish {
  double vertices;
  std::size_t part;
};

// The mean factor of lengths from the part to its place.
double scaleOf(const PartPlace& place) {
  return std::cbrt(std::abs(place.toWorld.linear().determinant()));
}

}  // namespace

PartTargets::PartTargets(const std::vector<io::Part>& parts, const std::vector<PartPlace>& places,
                         const PartOptions& options)
    : parts_(parts), places_(places), options_(options), order_(parts.size()) {
  if (parts.size() > 1 && !(options.density.empty() && options.featureEdges.empty()))
    throw Error(ErrorCode::InvalidOption,
                "density and featureEdges need a file with one mesh, not with " +
                    std::to_string(parts.size()) + ".",
                "Give the meshes one by one.");
  if (parts.size() > 1 && options.quads && isForced(options.symmetry))
    throw Error(ErrorCode::InvalidOption,
                "symmetry names planes, which go through the middle of one mesh; the file has " +
                    std::to_string(parts.size()) + ".",
                "Join the meshes to one, or use symmetry: auto.");
  // A single part does not share.
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double area = parts.size() > 1 ? places[i].area : 1;
    areas_.push_back(isLevel(i) ? 0 : area);
  }
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
    return isLevel(a) != isLevel(b) ? isLevel(b) : areas_[a] < areas_[b];
  });
  std::copy_if(order_.begin(), order_.end(), std::back_inserter(waiting_),
               [&](std::size_t i) { return !isLevel(i); });
  last_ = waiting_.empty() ? parts.size() : waiting_.back();
  given_.assign(parts.size(), 0);
  verticesLeft_ = options.vertices ? double(*options.vertices) : 0;
  reserved_.assign(parts.size(), 0);
  if (parts.size() <= 1 || !options.vertices) return;
  if (options.prefer == Prefer::Shape && !options.quads)
    byShape_.emplace(parts, places, options.textures);
  else
    reserveForCharts();
}

// Reserves vertices for charts, those with the smallest need first, as long as any are left.
void PartTargets::reserveForCharts() {
  const double area = std::accumulate(areas_.begin(), areas_.end(), 0.0);
  std::vector<Wish> wishes;
  for (const std::size_t i : waiting_)
    for (const ChartNeed& need : chartNeeds(parts_[i].mesh, options_))
      if (need.width * scaleOf(places_[i]) >= kShows * std::sqrt(area))
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

// The part's share by area of the vertices left, among the parts whose share is not below their
// reserve; the others get their reserve.
double PartTargets::shareOf(std::size_t part) const {
  if (byShape_) {
    const auto at = std::find(waiting_.begin(), waiting_.end(), part) - waiting_.begin();
    return byShape_->shares(waiting_, verticesLeft_)[std::size_t(at)];
  }
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

// A level keeps the same share of its own vertices as its finer parts kept of theirs.
PartOptions PartTargets::ofLevel(std::size_t part) const {
  double own = 0, given = 0;
  for (const std::size_t finer : parts_[part].finer) {
    own += double(countPlaces(parts_[finer].mesh.positions));
    given += given_[finer];
  }
  const double share = own > 0 && given > 0 ? given / own : 1;
  PartOptions result = options_;
  result.ratio.reset();
  result.edgeLength.reset();
  result.tooFew = TooFew::Raise;
  const double count = share * double(countPlaces(parts_[part].mesh.positions));
  result.vertices = Index(std::max(1LL, std::llround(count)));
  return result;
}

PartOptions PartTargets::of(std::size_t part) const {
  if (isLevel(part)) return ofLevel(part);
  PartOptions result = options_;
  const bool isLast = part == last_;
  // Other parts make up for a raised number, but the last part has only what is left. Without a
  // number for the whole, any part may be raised; a budget of faces is kept as near as may be.
  const bool asksForNone = !options_.vertices && !options_.ratio && !options_.edgeLength;
  const bool isOneOfMany = parts_.size() > 1 && !(isLast && options_.vertices && !options_.faces);
  if (asksForNone || isOneOfMany) result.tooFew = TooFew::Raise;
  if (options_.vertices) {
    result.vertices = Index(std::llround(isLast ? verticesLeft_ : shareOf(part)));
  }
  for (std::optional<double>* const length : {&result.edgeLength, &result.minEdge, &result.maxEdge})
    if (*length) **length /= scaleOf(places_[part]);
  return result;
}

// Enough for the whole: the part's share (by area, or what charts of others leave of it) of that
// number must cover the part's need and what others have been given.
void PartTargets::refuse(std::size_t part, const TooFewVertices& error) const {
  if (!options_.vertices || parts_.size() == 1) throw error;
  double area = 0, given = 0;
  bool hasCharts = false;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    area += areas_[i];
    given += isLevel(i) ? 0 : given_[i];
    hasCharts = hasCharts || reserved_[i] > 0;
  }
  const double share = areas_[part] / area * (hasCharts ? kLeftByArea : 1);
  const double least = double(error.enough) + given;
  const double enough = std::ceil(share > 0 ? least / share : least);
  const std::string number = std::to_string(std::llround(enough));
  throw Error(error.code,
              "The target of " + std::to_string(*options_.vertices) +
                  " vertices is too small for all " + std::to_string(parts_.size()) +
                  " meshes of the file: of it " + std::to_string(error.target) + " are left for " +
                  legible(parts_[part].name) + ", which are too few.",
              "Ask for " + number + " vertices or more, or give the meshes one by one.");
}

void PartTargets::given(std::size_t part, std::size_t vertices) {
  given_[part] = double(vertices);
  if (isLevel(part)) return;
  std::erase(waiting_, part);
  verticesLeft_ = std::max(0.0, verticesLeft_ - double(vertices));
}

}  // namespace remesher
