// SPDX-License-Identifier: MIT
// The parts of a painter's source that are computed once: its maps, its links between triangles,
// its texel counts.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/place.h"
#include "textures/painting/paint_source.h"
#include "textures/painting/tangents.h"

namespace remesher {

namespace {

constexpr int kTexcoordSets = 8;

Vec3 vectorOf(const Attribute& attribute, Index vertex) {
  const float* value = &attribute.values[std::size_t{vertex} * attribute.itemSize];
  return {value[0], value[1], value[2]};
}

const io::Image* imageOf(std::span<const io::NamedImage> images, const io::Map& map) {
  for (const io::NamedImage& image : images)
    if (map && image.name == map.image) return &image.image;
  return nullptr;
}

}  // namespace

PaintSource::PaintSource(SourceInput input) : input_(std::move(input)) {
  for (const io::Material& m : input_.materials) maps_.push_back(mapsFor(m));
  for (int i = 0; i < kTexcoordSets; ++i)
    texcoords_.push_back(findAttribute(mesh(), "TEXCOORD_" + std::to_string(i)));
  colors_ = findAttribute(mesh(), "COLOR_0");
  linkTriangles();
  shade();
  if (std::any_of(maps_.begin(), maps_.end(),
                  [](const Maps& maps) { return bool(maps.textures[NormalMap]); }))
    orient();
}

PaintSource::Maps PaintSource::mapsFor(const io::Material& m) const {
  const auto texture = [&](const io::Map& map, Coding coding) {
    return Texture(imageOf(input_.images, map), map, coding);
  };
  Maps maps;
  maps.textures = {texture(m.baseColorMap, Coding::Light),
                   texture(m.metalRoughMap, Coding::Fraction),
                   texture(m.occlusionMap, Coding::Fraction), texture(m.emissiveMap, Coding::Light),
                   texture(m.normalMap, Coding::Fraction)};
  const auto isLike = [&](std::size_t i, std::size_t j) {
    const auto& [a, b] =
        std::pair<const Texture&, const Texture&>(maps.textures[i], maps.textures[j]);
    return a && b && a.liesLike(b);
  };
  for (std::size_t i = 0; i < MapKinds; ++i) {
    maps.like[i] = 0;
    while (maps.like[i] < i && !isLike(maps.like[i], i)) ++maps.like[i];
  }
  return maps;
}

void PaintSource::linkTriangles() {
  place_ = weld(mesh().positions);
  starts_.assign(mesh().positions.size() + 1, 0);
  for (const Index v : mesh().indices) ++starts_[place_[v] + 1];
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  around_.resize(mesh().indices.size());
  std::vector<Index> next = starts_;
  for (Index h = 0; h < mesh().indices.size(); ++h)
    around_[next[place_[mesh().indices[h]]]++] = InputTriangle(h / 3);
}

void PaintSource::shade() {
  const Index count = Index(mesh().triangleCount());
  std::vector<Vec3> sums(mesh().positions.size(), Vec3::Zero());
  faceNormals_.resize(count);
  for (Index t = 0; t < count; ++t) {
    const Triangle c = corners(InputTriangle(t));
    faceNormals_[InputTriangle(t)] = unitNormal(c[0], c[1], c[2]);
    for (Index k = 0; k < 3; ++k)
      sums[place_[mesh().indices[3 * t + k]]] += areaVector(c[0], c[1], c[2]);
  }
  const Attribute* const given = findAttribute(mesh(), "NORMAL");
  for (Index h = 0; h < 3 * count; ++h) {
    const Index v = mesh().indices[h];
    const Vec3& own = faceNormals_[InputTriangle(h / 3)];
    if (given != nullptr && given->itemSize == 3)
      normals_.push_back(unitOr(vectorOf(*given, v), own));
    else
      normals_.push_back(input_.unshaded == Unshaded::Smooth ? unitOr(sums[place_[v]], own) : own);
  }
}

bool PaintSource::isFaceted() const {
  constexpr double kRounding = 1e-3;
  for (const io::Material& material : input_.materials)
    if (material.normalMap) return false;
  for (Index h = 0; h < normals_.size(); ++h)
    if ((normals_[h] - faceNormals_[InputTriangle(h / 3)]).norm() > kRounding) return false;
  return true;
}

void PaintSource::orient() {
  const Attribute* const given = findAttribute(mesh(), "TANGENT");
  if (given != nullptr && given->itemSize == 4) {
    for (const Index v : mesh().indices) {
      const Vec3 t = vectorOf(*given, v);
      tangents_.emplace_back(t.x(), t.y(), t.z(),
                             given->values[4 * std::size_t{v} + 3] < 0 ? -1 : 1);
    }
    return;
  }
  std::vector<Vec3> positions;
  std::vector<Vec2> texcoords;
  for (Index h = 0; h < mesh().indices.size(); ++h) {
    const Texture& map = mapsOf(InputTriangle(h / 3)).textures[NormalMap];
    positions.push_back(mesh().positions[mesh().indices[h]]);
    texcoords.push_back(texcoord(map ? map.texcoord() : 0, mesh().indices[h]));
  }
  tangents_ = computeTangents({positions, normals_, texcoords});
}

double PaintSource::texels(InputTriangle triangle) const {
  double most = 0;
  for (const Texture& map : mapsOf(triangle).textures) {
    if (!map) continue;
    const std::array<Vec2, 3> uv = texcoords(map.texcoord(), triangle);
    const Vec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    most = std::max(most, 0.5 * std::abs(a.x() * b.y() - a.y() * b.x()) * map.texels());
  }
  return most;
}

double PaintSource::colorTexels(InputTriangle triangle) const {
  // About eight of a byte's levels per texel.
  constexpr double kStep = 1.0 / 32;
  double most = 0;
  std::array<Eigen::Vector4d, 3> shown;
  for (Index k = 0; k < 3; ++k)
    shown[k] = vertexColor({triangle, Vec3::Unit(k)}).cwiseMax(0).cwiseMin(1).cwiseSqrt();
  for (std::size_t k = 0; k < 3; ++k)
    most = std::max(most, (shown[k] - shown[(k + 1) % 3]).cwiseAbs().maxCoeff());
  const double side = most / kStep;
  return std::sqrt(3.0) / 4 * side * side;
}

double PaintSource::largestMap(Index group) const {
  double most = 0;
  for (const Texture& map : maps_[group].textures)
    if (map) most = std::max(most, map.size());
  return most;
}

}  // namespace remesher
