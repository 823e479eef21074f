// SPDX-License-Identifier: MIT
#include "painting/painter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace remesher {

namespace {

// Points of a texel along a side.
constexpr double kFewest = 2, kMost = 8;

// What the points of a texel come to.
struct Mixture {
  Eigen::Vector4d baseColor = Eigen::Vector4d::Zero();
  Vec3 weighted = Vec3::Zero();  // colours times alpha
  Vec3 emissive = Vec3::Zero(), surface = Vec3::Zero(), normal = Vec3::Zero();
  int count = 0;

  void add(const Look& look, const Vec3& bent) {
    baseColor += look.baseColor;
    weighted += look.baseColor[3] * look.baseColor.head<3>();
    emissive += look.emissive;
    surface += look.surface;
    normal += bent;
    ++count;
  }
};

Vec3 mixed(const CanvasTriangle& t, const Vec3& weights, Vec3 CanvasCorner::*member) {
  return weights[0] * t.corners[0].*member + weights[1] * t.corners[1].*member +
         weights[2] * t.corners[2].*member;
}

// A direction in the frame that whoever draws the triangle will have there.
Vec3 inFrame(const CanvasTriangle& t, const Vec3& weights, const Vec3& normal,
             const Vec3& direction) {
  Vec3 tangent = Vec3::Zero();
  for (int k = 0; k < 3; ++k) tangent += weights[k] * t.corners[k].tangent.head<3>();
  const double length = tangent.norm();
  if (!(length > 0)) return Vec3::UnitZ();
  tangent /= length;
  Eigen::Matrix3d frame;
  frame << tangent, t.corners[0].tangent[3] * normal.cross(tangent), normal;
  const double volume = frame.determinant();
  if (!(std::abs(volume) > 1e-9)) return Vec3::UnitZ();
  Vec3 result = frame.inverse() * direction;
  // What faces away cannot be said: it lies along the surface.
  constexpr double kLowest = 0.05;
  result.z() = std::max(result.z(), kLowest);
  return result.normalized();
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
      finders_.emplace_back(*source);
    }
    for (io::Image* image :
         {&result_.baseColor, &result_.surface, &result_.emissive, &result_.normal})
      *image = {rules.size, rules.size, std::vector<std::uint8_t>(4 * owners_.size(), 255)};
  }

  Painting run(const Progress& progress) {
    // Triangle after triangle, for each has its own part of the original.
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < owners_.size(); ++i)
      if (owners_[i] != kNone) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return owners_[a] < owners_[b]; });
    Index current = kNone;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (owners_[order[i]] != current) {
        current = owners_[order[i]];
        enter(current);
        if (current % 64 == 0) progress.at(double(i) / double(order.size()));
      }
      put(order[i], mixtureAt(order[i], current));
    }
    for (io::Image* image :
         {&result_.baseColor, &result_.surface, &result_.emissive, &result_.normal})
      fillGutters(*image, owners_);
    return std::move(result_);
  }

 private:
  void enter(Index t) {
    const auto& c = triangles_[t].corners;
    finders_[triangles_[t].source].enter(
        {{c[0].position, c[1].position, c[2].position}, {c[0].place, c[1].place, c[2].place}});
  }

  Mixture mixtureAt(std::size_t texel, Index t) {
    const int side = int(std::clamp(std::ceil(rules_.finer - 1e-6), kFewest, kMost));
    const std::size_t column = texel % rules_.size, row = texel / rules_.size;
    const Vec2 corner{double(column), double(row)};
    Mixture mixture;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i)
        addPoint(mixture, t, corner + Vec2((i + 0.5) / side, (j + 0.5) / side));
    return mixture;
  }

  void addPoint(Mixture& mixture, Index t, const Vec2& texel) {
    const CanvasTriangle& triangle = triangles_[t];
    const Vec3 weights = weightsAt(plane_[t], texel);
    const Vec3 point = mixed(triangle, weights, &CanvasCorner::position);
    const Vec3 normal = mixed(triangle, weights, &CanvasCorner::normal).normalized();
    const InputPlace place = finders_[triangle.source].find(point, normal);
    const Look look = sources_[triangle.source]->at(place);
    mixture.add(look, inFrame(triangle, weights, normal, look.normal));
  }

  void put(std::size_t texel, const Mixture& mixture) {
    const double share = 1.0 / mixture.count;
    const double alpha = share * mixture.baseColor[3];
    Vec3 color = share * mixture.baseColor.head<3>();
    if (!rules_.isOpaque && alpha > 0) color = mixture.weighted / mixture.baseColor[3];
    const Vec3 normal = mixture.normal.normalized();
    for (std::size_t c = 0; c < 3; ++c) {
      const auto k = Eigen::Index(c);
      result_.baseColor.texels[4 * texel + c] = srgbOf(color[k]);
      result_.emissive.texels[4 * texel + c] = srgbOf(share * mixture.emissive[k]);
      result_.surface.texels[4 * texel + c] = byteOf(share * mixture.surface[k]);
      result_.normal.texels[4 * texel + c] = byteOf(0.5 + 0.5 * normal[k]);
    }
    if (!rules_.isOpaque) result_.baseColor.texels[4 * texel + 3] = byteOf(alpha);
  }

  std::span<const CanvasTriangle> triangles_;
  PaintRules rules_;
  std::vector<const PaintSource*> sources_;
  std::vector<SideFinder> finders_;
  std::vector<TexelTriangle> plane_;
  std::vector<Index> owners_;
  Painting result_;
};

}  // namespace

Painting paint(std::span<const CanvasTriangle> triangles,
               std::span<const std::unique_ptr<PaintSource>> sources, const PaintRules& rules,
               const Progress& progress) {
  return Painter(triangles, sources, rules).run(progress);
}

}  // namespace remesher
