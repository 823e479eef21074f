// SPDX-License-Identifier: MIT
#include "painting/paint_source.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/place.h"
#include "painting/tangents.h"

namespace remesher {

namespace {

constexpr int kTexcoordSets = 8;

const io::Image* imageOf(std::span<const io::NamedImage> images, const io::Map& map) {
  for (const io::NamedImage& image : images)
    if (map && image.name == map.image) return &image.image;
  return nullptr;
}

Vec3 unitOr(const Vec3& v, const Vec3& otherwise) {
  const double length = v.norm();
  return length > 0 && std::isfinite(length) ? Vec3(v / length) : otherwise;
}

Vec3 vectorOf(const Attribute& attribute, Index vertex) {
  const float* value = &attribute.values[std::size_t{vertex} * attribute.itemSize];
  return {value[0], value[1], value[2]};
}

Vec2 pairOf(const Attribute& attribute, Index vertex) {
  const float* value = &attribute.values[2 * std::size_t{vertex}];
  return {value[0], value[1]};
}

}  // namespace

InputPlace middleOf(std::span<const InputPlace> places) {
  Vec3 sum = Vec3::Zero();
  for (const InputPlace& place : places) sum += place.weights;
  return {places.front().triangle, sum / double(places.size())};
}

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

Triangle PaintSource::corners(Index triangle) const {
  Triangle result;
  for (Index k = 0; k < 3; ++k) result[k] = mesh().positions[mesh().indices[3 * triangle + k]];
  return result;
}

std::span<const Index> PaintSource::around(Index corner) const {
  const Index place = place_[mesh().indices[corner]];
  return std::span(around_).subspan(starts_[place], starts_[place + 1] - starts_[place]);
}

const io::Material& PaintSource::materialOf(Index triangle) const {
  const Index group = mesh().groups.empty() ? 0 : mesh().groups[triangle];
  return group < input_.materials.size() ? input_.materials[group] : plain_;
}

const PaintSource::Maps& PaintSource::mapsOf(Index triangle) const {
  static const Maps kNoMaps{};
  const Index group = mesh().groups.empty() ? 0 : mesh().groups[triangle];
  return group < maps_.size() ? maps_[group] : kNoMaps;
}

void PaintSource::linkTriangles() {
  place_ = weld(mesh().positions);
  starts_.assign(mesh().positions.size() + 1, 0);
  for (const Index v : mesh().indices) ++starts_[place_[v] + 1];
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  around_.resize(mesh().indices.size());
  std::vector<Index> next = starts_;
  for (Index h = 0; h < mesh().indices.size(); ++h)
    around_[next[place_[mesh().indices[h]]]++] = h / 3;
}

void PaintSource::shade() {
  const Index count = Index(mesh().triangleCount());
  std::vector<Vec3> sums(mesh().positions.size(), Vec3::Zero());
  for (Index t = 0; t < count; ++t) {
    const Triangle c = corners(t);
    faceNormals_.push_back(unitNormal(c[0], c[1], c[2]));
    for (Index k = 0; k < 3; ++k)
      sums[place_[mesh().indices[3 * t + k]]] += areaVector(c[0], c[1], c[2]);
  }
  const Attribute* const given = findAttribute(mesh(), "NORMAL");
  for (Index h = 0; h < 3 * count; ++h) {
    const Index v = mesh().indices[h];
    const Vec3& own = faceNormals_[h / 3];
    if (given != nullptr && given->itemSize == 3)
      normals_.push_back(unitOr(vectorOf(*given, v), own));
    else
      normals_.push_back(input_.unshaded == Unshaded::Smooth ? unitOr(sums[place_[v]], own) : own);
  }
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
    const Texture& map = mapsOf(h / 3).textures[NormalMap];
    positions.push_back(mesh().positions[mesh().indices[h]]);
    texcoords.push_back(texcoord(map ? map.texcoord() : 0, mesh().indices[h]));
  }
  tangents_ = computeTangents({positions, normals_, texcoords});
}

Vec2 PaintSource::texcoord(int set, Index vertex) const {
  const Attribute* const at = set >= 0 && set < kTexcoordSets ? texcoords_[set] : nullptr;
  return at != nullptr && at->itemSize == 2 ? pairOf(*at, vertex) : Vec2(0, 0);
}

std::array<Vec2, 3> PaintSource::texcoords(int set, Index triangle) const {
  const Index* const corners = &mesh().indices[3 * std::size_t{triangle}];
  return {texcoord(set, corners[0]), texcoord(set, corners[1]), texcoord(set, corners[2])};
}

Vec3 PaintSource::position(const InputPlace& place) const {
  const Triangle c = corners(place.triangle);
  return place.weights[0] * c[0] + place.weights[1] * c[1] + place.weights[2] * c[2];
}

Vec3 PaintSource::shadingNormal(const InputPlace& place) const {
  Vec3 sum = Vec3::Zero();
  for (Index k = 0; k < 3; ++k) sum += place.weights[k] * normals_[3 * place.triangle + k];
  return unitOr(sum, faceNormals_[place.triangle]);
}

PaintSource::Texels PaintSource::lookUp(std::span<const InputPlace> places) const {
  const Index triangle = places.front().triangle;
  const Maps& maps = mapsOf(triangle);
  Texels texels;
  std::array<Eigen::Vector4f, MapKinds> sums;
  std::array<std::array<Vec2, 3>, MapKinds> corners;
  for (std::size_t i = 0; i < MapKinds; ++i) {
    sums[i].setZero();
    if (maps.textures[i] && maps.like[i] == i)
      corners[i] = texcoords(maps.textures[i].texcoord(), triangle);
  }
  std::array<Texture::Spot, MapKinds> spots;
  for (const auto& [_, weights] : places)
    for (std::size_t i = 0; i < MapKinds; ++i) {
      const Texture& map = maps.textures[i];
      if (!map) continue;
      const auto& uv = corners[i];
      if (maps.like[i] == i)
        spots[i] = map.spotAt(weights[0] * uv[0] + weights[1] * uv[1] + weights[2] * uv[2]);
      sums[i] += map.at(spots[maps.like[i]]);
    }
  const double share = 1.0 / double(places.size());
  for (std::size_t i = 0; i < MapKinds; ++i)
    texels[i] = maps.textures[i] ? Eigen::Vector4d(share * sums[i].cast<double>())
                                 : Eigen::Vector4d(Eigen::Vector4d::Ones());
  return texels;
}

Eigen::Vector4d PaintSource::vertexColor(const InputPlace& place) const {
  Eigen::Vector4d sum = Eigen::Vector4d::Ones();
  if (colors_ == nullptr) return sum;
  for (int c = 0; c < std::min(4, colors_->itemSize); ++c) {
    sum[c] = 0;
    for (Index k = 0; k < 3; ++k) {
      const std::size_t v = mesh().indices[3 * place.triangle + k];
      sum[c] += place.weights[k] * colors_->values[v * colors_->itemSize + c];
    }
  }
  return sum;
}

// The normal as the normal map bends it.
Vec3 PaintSource::bent(const Vec3& normal, const InputPlace& place,
                       const Eigen::Vector4d& texel) const {
  if (!mapsOf(place.triangle).textures[NormalMap]) return normal;
  const double scale = materialOf(place.triangle).normalScale;
  Vec3 tangent = Vec3::Zero();
  for (Index k = 0; k < 3; ++k)
    tangent += place.weights[k] * tangents_[3 * place.triangle + k].head<3>();
  tangent = unitOr(tangent, Vec3::Zero());
  const Vec3 bitangent = tangents_[3 * place.triangle][3] * normal.cross(tangent);
  return unitOr(scale * (2 * texel[0] - 1) * tangent + scale * (2 * texel[1] - 1) * bitangent +
                    (2 * texel[2] - 1) * normal,
                normal);
}

Look PaintSource::at(std::span<const InputPlace> places) const {
  const InputPlace place = middleOf(places);
  const io::Material& material = materialOf(place.triangle);
  const Texels texels = lookUp(places);
  Look look;
  look.baseColor =
      material.baseColor.cwiseProduct(texels[BaseColorMap]).cwiseProduct(vertexColor(place));
  look.emissive = material.emissive.cwiseProduct(texels[EmissiveMap].head<3>());
  look.surface = {1 + material.occlusionStrength * (texels[OcclusionMap][0] - 1),
                  material.roughness * texels[MetalRoughMap][1],
                  material.metallic * texels[MetalRoughMap][2]};
  look.normal = bent(shadingNormal(place), place, texels[NormalMap]);
  return look;
}

double PaintSource::texels(Index triangle) const {
  double most = 0;
  for (const Texture& map : mapsOf(triangle).textures) {
    if (!map) continue;
    const std::array<Vec2, 3> uv = texcoords(map.texcoord(), triangle);
    const Vec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    most = std::max(most, 0.5 * std::abs(a.x() * b.y() - a.y() * b.x()) * map.texels());
  }
  return most;
}

double PaintSource::largestMap(Index group) const {
  double most = 0;
  for (const Texture& map : maps_[group].textures)
    if (map) most = std::max(most, map.size());
  return most;
}

}  // namespace remesher
