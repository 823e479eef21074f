// SPDX-License-Identifier: MIT
#include "textures/painting/new_surface.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "base/place.h"
#include "geometry/triangle.h"
#include "textures/painting/corner_values.h"

namespace remesher {

namespace {

Vec3 rounded(const Vec3& v) { return v.cast<float>().cast<double>(); }

// The least cosine between the direction of a vertex and one side of a sharp edge there for which
// the side's points can be looked for in that direction.
constexpr double kStillFacing = 0.15;

// The values by which copies of a vertex differ.
using CopyKey = std::array<double, 10>;

// The faces in the drawing order of the original triangles they lie on: with transparency later
// faces lie over earlier ones. corners: of a face.
std::vector<Index> drawingOrder(std::span<const InputPlace> places, std::size_t corners) {
  std::vector<Index> order(places.size() / corners);
  std::vector<InputTriangle> middles, drawn(corners, InputTriangle{0});
  for (std::size_t h = 0; h < places.size(); h += corners) {
    for (std::size_t k = 0; k < corners; ++k) drawn[k] = places[h + k].triangle;
    std::sort(drawn.begin(), drawn.end());
    middles.push_back(drawn[corners / 2]);
  }
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return middles[a] < middles[b]; });
  return order;
}

// About the direction whose largest angle with any of these is least [Aubry & Löhner 2008].
Vec3 mostNormal(std::span<const Vec3> normals) {
  constexpr double kEnough = 0.5, kTurn = 0.3;
  constexpr int kMostTurns = 32;
  Vec3 sum = Vec3::Zero();
  for (const Vec3& n : normals) sum += n;
  Vec3 next = unitOr(sum, Vec3::Zero()), best = next;
  double least = -kInfinity;
  for (int i = 0; i < kMostTurns && least < kEnough && !normals.empty(); ++i) {
    const Vec3& worst =
        *std::min_element(normals.begin(), normals.end(),
                          [&](const Vec3& a, const Vec3& b) { return a.dot(next) < b.dot(next); });
    if (worst.dot(next) > least) best = next;
    least = std::max(least, worst.dot(next));
    next = unitOr(next + kTurn * worst, worst);
  }
  return best;
}

}  // namespace

NewSurface::NewSurface(const TriangleMesh& mesh, std::span<const InputPlace> places,
                       const PaintSource& source)
    : mesh_(mesh),
      places_(places),
      texcoords_(mesh.indices.size(), Vec2::Zero()),
      tangents_(mesh.indices.size(), Eigen::Vector4d(1, 0, 0, 1)) {
  for (const Vec3& p : mesh.positions) positions_.push_back(rounded(p));
  const std::vector<Index> first = weld(mesh.positions);
  for (const Index v : mesh.indices) welded_.push_back(first[v]);
  for (const auto& [shape, light] : shade(positions_, welded_, places, source, kind()))
    normals_.push_back({rounded(shape), rounded(light)});
}

void NewSurface::setTexcoord(Index corner, const Vec2& texel, Index size) {
  texcoords_[corner] = (texel / size).cast<float>().cast<double>();
}

CanvasCorner NewSurface::canvasCorner(Index corner, Index size) const {
  return {position(corner),  facing(corner),          normal(corner),
          tangents_[corner], texcoord(corner) * size, places_[corner]};
}

std::optional<Index> NewSurface::cornerInQuad(Index corner) const {
  if (!mesh_.isQuads || corner / 3 % 2 == 0) return {};
  const Index first = corner / 3 * 3 - 3;
  for (Index h = first; h < first + 3; ++h)
    if (mesh_.indices[h] == mesh_.indices[corner] && texcoords_[h] == texcoords_[corner]) return h;
  return {};
}

void NewSurface::takeNormals() {
  const Attribute* const own = findAttribute(mesh_, "NORMAL");
  if (own == nullptr || own->itemSize != 3) return;
  for (Index h = 0; h < mesh_.indices.size(); ++h) {
    const float* const n = &own->values[3 * std::size_t{mesh_.indices[h]}];
    normals_[h].light = rounded(unitOr(Vec3(n[0], n[1], n[2]), normals_[h].light));
  }
}

void NewSurface::joinFacings() {
  std::vector<std::vector<Vec3>> around(positions_.size());
  for (Index h = 0; h < welded_.size(); ++h) {
    const Index first = h - h % 3;
    const Vec3 normal = unitNormal(position(first), position(first + 1), position(first + 2));
    if (!normal.isZero()) around[welded_[h]].push_back(normal);
  }
  std::vector<Vec3> joined;
  for (const std::vector<Vec3>& normals : around) joined.push_back(rounded(mostNormal(normals)));
  for (Index h = 0; h < welded_.size(); ++h)
    if (joined[welded_[h]].dot(facing(h)) > kStillFacing) normals_[h].shape = joined[welded_[h]];
}

TriangleMesh NewSurface::paintedInOrder() const {
  CornerValues normals{"NORMAL", 3, {}}, tangents{"TANGENT", 4, {}}, texcoords{"TEXCOORD_0", 2, {}};
  for (Index corner = 0; corner < mesh_.indices.size(); ++corner) {
    const Index h = cornerInQuad(corner).value_or(corner);
    for (const double x : normal(h)) normals.values.push_back(float(x));
    for (const double x : tangents_[h]) tangents.values.push_back(float(x));
    for (const double x : texcoords_[h]) texcoords.values.push_back(float(x));
  }
  std::vector<CornerValues> all = {std::move(normals), std::move(texcoords)};
  if (hasTangents_) all.push_back(std::move(tangents));
  TriangleMesh bare = mesh_;
  std::erase_if(bare.attributes, [](const Attribute& attribute) {
    const std::string own = attribute.semantic.substr(attribute.semantic.find('/') + 1);
    return own == "TANGENT" || attribute.semantic.starts_with("COLOR_");
  });
  return withCorners(std::move(bare), all);
}

TriangleMesh NewSurface::painted() const {
  TriangleMesh result;
  result.isQuads = mesh_.isQuads;
  for (const Attribute& attribute : mesh_.attributes)
    result.attributes.push_back({attribute.semantic, attribute.itemSize, {}});
  Attribute normals{"NORMAL", 3, {}}, tangents{"TANGENT", 4, {}}, texcoords{"TEXCOORD_0", 2, {}};
  std::map<CopyKey, Index> copies;
  const auto addCorner = [&](Index corner) {
    const Index h = cornerInQuad(corner).value_or(corner);
    const Index v = mesh_.indices[h];
    const Vec3 n = hasNormals_ ? normal(h) : Vec3::Zero();
    const Vec2& uv = texcoords_[h];
    const Eigen::Vector4d& t = tangents_[h];
    const CopyKey key = {double(v), n.x(), n.y(), n.z(), uv.x(),
                         uv.y(),    t.x(), t.y(), t.z(), t.w()};
    const auto [copy, isNew] = copies.emplace(key, Index(result.positions.size()));
    result.indices.push_back(copy->second);
    if (!isNew) return;
    result.positions.push_back(mesh_.positions[v]);
    for (std::size_t a = 0; a < mesh_.attributes.size(); ++a)
      appendValue(result.attributes[a], mesh_.attributes[a], v);
    for (const double x : n) normals.values.push_back(float(x));
    for (const double x : t) tangents.values.push_back(float(x));
    for (const double x : uv) texcoords.values.push_back(float(x));
  };
  const Index corners = mesh_.isQuads ? 6 : 3;
  for (const Index face : drawingOrder(places_, corners)) {
    for (Index h = corners * face; h < corners * (face + 1); ++h) {
      addCorner(h);
      if (!mesh_.groups.empty() && h % 3 == 0) result.groups.push_back(mesh_.groups[h / 3]);
    }
  }
  if (hasNormals_) result.attributes.push_back(std::move(normals));
  if (hasTangents_) result.attributes.push_back(std::move(tangents));
  result.attributes.push_back(std::move(texcoords));
  return result;
}

}  // namespace remesher
