// SPDX-License-Identifier: MIT
#include "textures/painting/paint_source.h"

#include <algorithm>
#include <cmath>

namespace remesher {

namespace {

Vec2 pairOf(const Attribute& attribute, Index vertex) {
  const float* value = &attribute.values[2 * std::size_t{vertex}];
  return {value[0], value[1]};
}

}  // namespace

Vec3 unitOr(const Vec3& v, const Vec3& otherwise) {
  const double length = v.norm();
  return length > 0 && std::isfinite(length) ? Vec3(v / length) : otherwise;
}

InputPlace middleOf(std::span<const InputPlace> places) {
  Vec3 sum = Vec3::Zero();
  for (const InputPlace& place : places) sum += place.weights;
  return {places.front().triangle, sum / double(places.size())};
}

Triangle PaintSource::corners(InputTriangle triangle) const {
  Triangle result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = mesh().positions[mesh().indices[cornerOf(triangle, k)]];
  return result;
}

std::span<const InputTriangle> PaintSource::around(InputTriangle triangle, std::size_t k) const {
  const Index place = place_[mesh().indices[cornerOf(triangle, k)]];
  return std::span(around_).subspan(starts_[place], starts_[place + 1] - starts_[place]);
}

const io::Material& PaintSource::materialOf(InputTriangle triangle) const {
  const Index group = mesh().groups.empty() ? 0 : mesh().groups[triangle.index];
  return group < input_.materials.size() ? input_.materials[group] : plain_;
}

const PaintSource::Maps& PaintSource::mapsOf(InputTriangle triangle) const {
  static const Maps kNoMaps{};
  const Index group = mesh().groups.empty() ? 0 : mesh().groups[triangle.index];
  return group < maps_.size() ? maps_[group] : kNoMaps;
}

Vec2 PaintSource::texcoord(int set, Index vertex) const {
  const bool isKnown = set >= 0 && std::size_t(set) < texcoords_.size();
  const Attribute* const at = isKnown ? texcoords_[std::size_t(set)] : nullptr;
  return at != nullptr && at->itemSize == 2 ? pairOf(*at, vertex) : Vec2(0, 0);
}

std::array<Vec2, 3> PaintSource::texcoords(int set, InputTriangle triangle) const {
  const Index* const corners = &mesh().indices[cornerOf(triangle, 0)];
  return {texcoord(set, corners[0]), texcoord(set, corners[1]), texcoord(set, corners[2])};
}

Vec3 PaintSource::position(const InputPlace& place) const {
  const Triangle c = corners(place.triangle);
  return place.weights[0] * c[0] + place.weights[1] * c[1] + place.weights[2] * c[2];
}

Vec3 PaintSource::shadingNormal(const InputPlace& place) const {
  Vec3 sum = Vec3::Zero();
  for (Index k = 0; k < 3; ++k) sum += place.weights[k] * normals_[cornerOf(place.triangle, k)];
  return unitOr(sum, faceNormals_[place.triangle]);
}

PaintSource::Texels PaintSource::lookUp(std::span<const InputPlace> places) const {
  const InputTriangle triangle = places.front().triangle;
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
      const std::size_t v = mesh().indices[cornerOf(place.triangle, k)];
      sum[c] += place.weights[k] * colors_->values[v * colors_->itemSize + c];
    }
  }
  return sum;
}

// The normal as bent by the normal map.
Vec3 PaintSource::bent(const Vec3& normal, const InputPlace& place,
                       const Eigen::Vector4d& texel) const {
  if (!mapsOf(place.triangle).textures[NormalMap]) return normal;
  const double scale = materialOf(place.triangle).normalScale;
  Vec3 tangent = Vec3::Zero();
  for (Index k = 0; k < 3; ++k)
    tangent += place.weights[k] * tangents_[cornerOf(place.triangle, k)].head<3>();
  tangent = unitOr(tangent, Vec3::Zero());
  const Vec3 bitangent = tangents_[cornerOf(place.triangle, 0)][3] * normal.cross(tangent);
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

}  // namespace remesher
