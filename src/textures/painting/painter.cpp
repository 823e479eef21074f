// SPDX-License-Identifier: MIT
#include "textures/painting/painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "textures/painting/cage_finder.h"
#include "textures/painting/occlusion.h"
#include "textures/painting/side_finder.h"

namespace remesher {

namespace {

// Points per texel along a side.
constexpr double kFewest = 2, kMost = 8;
// If the original's texels are finer by at most this factor along a side (two of them per new one),
// one look-up mixes them well enough, because it interpolates between four texels.
constexpr double kAlike = std::numbers::sqrt2;
// Up to this factor two looks on a texel's diagonal suffice: over all texels they are the corners
// and middles of squares, no farther apart than kAlike allows. With a factor of 2 they would see
// only one colour of a chequerboard.
constexpr double kDiagonal = 1.9;

// The sum of the looks at the points of a texel.
struct Mixture {
  Eigen::Vector4d baseColor = Eigen::Vector4d::Zero();
  Vec3 colourByAlpha = Vec3::Zero();
  Vec3 emissive = Vec3::Zero(), surface = Vec3::Zero(), normal = Vec3::Zero();
  int count = 0;

  void add(const Look& look, int points) {
    baseColor += points * look.baseColor;
    colourByAlpha += points * look.baseColor[3] * look.baseColor.head<3>();
    emissive += points * look.emissive;
    surface += points * look.surface;
    normal += points * look.normal;
    count += points;
  }
};

// A vector that is an affine function of the texel coordinates.
struct AffineVector {
  Vec2 from;
  Vec3 there, perX, perY;

  Vec3 at(const Vec2& texel) const {
    const Vec2 way = texel - from;
    return there + way.x() * perX + way.y() * perY;
  }
};

// The affine vector with these values at the corners.
AffineVector affineOf(const TexelTriangle& plane, const std::array<Vec3, 3>& values) {
  const auto at = [&](const Vec2& texel) -> Vec3 {
    const Vec3 weights = weightsAt(plane, texel);
    return weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2];
  };
  const Vec3 there = at(plane[0]);
  return {plane[0], there, at(plane[0] + Vec2::UnitX()) - there,
          at(plane[0] + Vec2::UnitY()) - there};
}

// A direction in the tangent frame that a renderer will have there. The tangent may have any
// length; side is the side of the bitangent.
Vec3 inFrame(const Vec3& tangent, double side, const Vec3& normal, const Vec3& direction) {
  const double length = tangent.norm();
  if (!(length > 0)) return Vec3::UnitZ();
  const Vec3 along = tangent / length, across = normal.cross(along), bitangent = side * across;
  const Vec3 facing = bitangent.cross(normal);
  const double volume = along.dot(facing);
  if (!(std::abs(volume) > 1e-9)) return Vec3::UnitZ();
  Vec3 result =
      Vec3(facing.dot(direction), across.dot(direction), along.cross(bitangent).dot(direction)) /
      volume;
  // A normal map cannot hold a direction that faces away: it is bent to just above the surface.
  constexpr double kLowest = 0.05;
  result.z() = std::max(result.z(), kLowest);
  return result.normalized();
}

std::unique_ptr<PaintFinder> finderOn(const PaintSource& source, const PaintRules& rules,
                                      std::size_t number) {
  if (rules.cages.empty()) return std::make_unique<SideFinder>(source);
  return std::make_unique<CageFinder>(source, rules.cages[number]);
}

class Painter {
 public:
  Painter(std::span<const CanvasTriangle> triangles,
          std::span<const std::unique_ptr<PaintSource>> sources, const PaintRules& rules)
      : triangles_(triangles), rules_(rules) {
    for (const CanvasTriangle& t : triangles)
      plane_.push_back({t.corners[0].texel, t.corners[1].texel, t.corners[2].texel});
    owners_ = coveredTexels(plane_, rules.size);
    for (const auto& source : sources) {
      sources_.push_back(source.get());
      finders_.push_back(finderOn(*source, rules, finders_.size()));
      if (rules.occludes)
        occlusions_.emplace_back(source->mesh().positions, source->mesh().indices);
    }
    for (io::Image* image :
         {&result_.baseColor, &result_.surface, &result_.emissive, &result_.normal})
      *image = {rules.size, rules.size, std::vector<std::uint8_t>(4 * owners_.size(), 255)};
    const int side = int(std::clamp(std::ceil(rules.finer / kAlike), kFewest, kMost));
    const bool isDiagonal = rules.finer > kAlike && rules.finer <= kDiagonal;
    for (int i = 0; i < side * side; ++i) {
      const int column = i % side, row = i / side;
      if (isDiagonal && column != row) continue;
      spread_.push_back(Vec2(column + 0.5, row + 0.5) / side);
    }
  }

  Painting run(const Progress& progress) {
    const std::vector<std::size_t> order = texelsByOwner();
    Index current = kNone;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (owners_[order[i]] != current) {
        current = owners_[order[i]];
        enter(current);
        if (current % 64 == 0) progress.at(double(i) / double(order.size()));
      }
      const Mixture mixture = mixtureAt(order[i]);
      if (mixture.count > 0)
        put(order[i], mixture);
      else
        lost_.push_back(order[i]);
    }
    result_.texels = order.size();
    result_.lost = lost_.size();
    for (const std::size_t texel : lost_) owners_[texel] = kNone;
    if (rules_.occludes) darken();
    const std::array<io::Image*, 4> images = {&result_.baseColor, &result_.surface,
                                              &result_.emissive, &result_.normal};
    fillGutters(images, owners_);
    return std::move(result_);
  }

 private:
  // The texels by triangle, because each triangle has its own part of the original.
  std::vector<std::size_t> texelsByOwner() const {
    std::vector<std::size_t> starts(triangles_.size() + 1);
    for (const Index owner : owners_)
      if (owner != kNone) ++starts[owner + 1];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<std::size_t> order(starts.back());
    for (std::size_t i = 0; i < owners_.size(); ++i)
      if (owners_[i] != kNone) order[starts[owners_[i]]++] = i;
    return order;
  }

  void enter(Index t) {
    triangle_ = &triangles_[t];
    finder_ = finders_[triangle_->source].get();
    source_ = sources_[triangle_->source];
    const auto& c = triangle_->corners;
    finder_->enter(
        {{c[0].position, c[1].position, c[2].position}, {c[0].place, c[1].place, c[2].place}});
    outline_ = RimmedTriangle(plane_[t], triangle_->rims);
    points_ = affineOf(plane_[t], {c[0].position, c[1].position, c[2].position});
    facings_ = affineOf(plane_[t], {c[0].facing, c[1].facing, c[2].facing});
    normals_ = affineOf(plane_[t], {c[0].normal, c[1].normal, c[2].normal});
    tangents_ = affineOf(plane_[t],
                         {c[0].tangent.head<3>(), c[1].tangent.head<3>(), c[2].tangent.head<3>()});
  }

  Mixture mixtureAt(std::size_t texel) {
    const Vec2 corner = cornerOf(texel);
    middle_ = corner + Vec2::Constant(0.5);
    findPlaces(corner);
    Mixture mixture;
    const bool isAlike = rules_.finer <= kAlike;
    for (std::size_t i = 0, end = 0; i < places_.size(); i = end) {
      end = isAlike || rules_.isOpaque ? groupByTriangle(i) : i + 1;
      std::span<const InputPlace> here(&places_[i], end - i);
      const InputPlace middle = middleOf(here);
      if (isAlike) here = {&middle, 1};
      mixture.add(source_->at(here), int(end - i));
    }
    return mixture;
  }

  // Moves the places on the same triangle as places_[first] next to it; returns the end of the
  // group.
  std::size_t groupByTriangle(std::size_t first) {
    std::size_t end = first + 1;
    for (std::size_t k = end; k < places_.size(); ++k)
      if (places_[k].triangle == places_[first].triangle) std::swap(places_[k], places_[end++]);
    return end;
  }

  // The places of a texel's points. Points beyond a rim belong to another chart: they are used,
  // moved inside, only if the texel has no other point.
  void findPlaces(const Vec2& corner) {
    if (findTogether(corner)) return;
    places_.clear();
    for (const bool isWithin : {true, false}) {
      for (const Vec2& offset : spread_) {
        const Vec2 point = corner + offset, at = outline_.kept(point);
        if (isWithin && at != point) continue;
        const auto place = finder_->placeFor(points_.at(at), facings_.at(at).normalized());
        if (place) places_.push_back(*place);
      }
      if (!places_.empty()) return;
    }
  }

  // Fills places_ from the place of the texel's middle alone, without a search; false unless all
  // points are inside the rims and on one triangle, as those of most texels are.
  bool findTogether(const Vec2& corner) {
    const auto isCutOff = [&](const Vec2& offset) {
      const Vec2 point = corner + offset;
      return outline_.kept(point) != point;
    };
    if (std::any_of(spread_.begin(), spread_.end(), isCutOff)) return false;
    const auto found = finder_->findMoving(points_.at(middle_), facings_.at(middle_).normalized(),
                                           {points_.perX, points_.perY});
    if (!found) return false;
    places_.clear();
    for (const Vec2& offset : spread_) {
      const Vec2 way = offset - Vec2::Constant(0.5);
      places_.push_back({found->place.triangle,
                         found->place.weights + way.x() * found->perX + way.y() * found->perY});
    }
    return std::all_of(places_.begin(), places_.end(),
                       [](const InputPlace& place) { return place.weights.minCoeff() >= 0; });
  }

  Vec2 cornerOf(std::size_t texel) const {
    const std::size_t column = texel % rules_.size, row = texel / rules_.size;
    return {double(column), double(row)};
  }

  // A direction as the normal map stores it at the middle of the texel.
  Vec3 written(const Vec3& direction) const {
    return inFrame(tangents_.at(middle_), triangle_->corners[0].tangent[3],
                   normals_.at(middle_).normalized(), direction);
  }

  void put(std::size_t texel, const Mixture& mixture) {
    const double share = 1.0 / mixture.count;
    const double alpha = share * mixture.baseColor[3];
    Vec3 color = share * mixture.baseColor.head<3>();
    if (!rules_.isOpaque && alpha > 0) color = mixture.colourByAlpha / mixture.baseColor[3];
    const Vec3 normal = written(mixture.normal.normalized());
    for (std::size_t c = 0; c < 3; ++c) {
      const auto k = Eigen::Index(c);
      result_.baseColor.texels[4 * texel + c] = srgbOf(color[k]);
      result_.emissive.texels[4 * texel + c] = srgbOf(share * mixture.emissive[k]);
      result_.surface.texels[4 * texel + c] = byteOf(share * mixture.surface[k]);
      result_.normal.texels[4 * texel + c] = byteOf(0.5 + 0.5 * normal[k]);
    }
    if (!rules_.isOpaque) result_.baseColor.texels[4 * texel + 3] = byteOf(alpha);
    if (rules_.occludes) noteOpenness(texel);
  }

  // Notes the texel's openness, at the first of its places.
  void noteOpenness(std::size_t texel) {
    const InputPlace& place = places_.front();
    const Vec3 at = source_->position(place), normal = source_->shadingNormal(place);
    const Vec2 corner = cornerOf(texel);
    open_.resize(owners_.size());
    open_[texel] = {float(occlusions_[triangle_->source].openness(at, normal, Index(corner.x()),
                                                                  Index(corner.y()))),
                    at.cast<float>(), normal.cast<float>()};
  }

  // The darker of the material's occlusion and the shape's counts.
  void darken() {
    if (open_.empty()) return;
    const std::vector<float> means = meansOver(open_, owners_, rules_.size);
    for (std::size_t i = 0; i < owners_.size(); ++i) {
      std::uint8_t& byte = result_.surface.texels[4 * i];
      if (owners_[i] != kNone) byte = std::min(byte, byteOf(double(means[i])));
    }
  }

  std::span<const CanvasTriangle> triangles_;
  PaintRules rules_;
  std::vector<Vec2> spread_;  // the points of a texel, from its corner
  std::vector<const PaintSource*> sources_;
  std::vector<std::unique_ptr<PaintFinder>> finders_;
  std::vector<OcclusionMap> occlusions_;  // per source, if occlusion is painted
  std::vector<OccludedTexel> open_;       // per texel, likewise
  std::vector<std::size_t> lost_;         // texels for which nothing was found
  std::vector<TexelTriangle> plane_;
  std::vector<Index> owners_;
  Painting result_;
  // The triangle being painted.
  const CanvasTriangle* triangle_ = nullptr;
  const PaintSource* source_ = nullptr;
  PaintFinder* finder_ = nullptr;
  RimmedTriangle outline_;
  AffineVector points_, facings_, normals_, tangents_;
  // The texel being painted.
  Vec2 middle_ = Vec2::Zero();
  std::vector<InputPlace> places_;
};

}  // namespace

Painting paint(std::span<const CanvasTriangle> triangles,
               std::span<const std::unique_ptr<PaintSource>> sources, const PaintRules& rules,
               const Progress& progress) {
  return Painter(triangles, sources, rules).run(progress);
}

}  // namespace remesher
