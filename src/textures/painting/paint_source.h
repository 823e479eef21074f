// SPDX-License-Identifier: MIT
// The original as a painter sees it: at any place its colours, its roughness and so on, and the
// direction that light takes for its normal.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/input_place.h"
#include "base/triangle_mesh.h"
#include "geometry/triangle.h"
#include "textures/painting/texture.h"

namespace remesher {

struct Look {
  Eigen::Vector4d baseColor = Eigen::Vector4d::Zero();  // light, and alpha
  Vec3 emissive = Vec3::Zero();                         // light
  Vec3 surface = Vec3::Zero();                          // occlusion, roughness, metal
  Vec3 normal = Vec3::Zero();                           // unit
};

// What a mesh without normals is shaded like.
enum class Unshaded { Flat, Smooth };

struct SourceInput {
  const TriangleMesh* mesh;
  std::vector<io::Material> materials;  // per group
  std::span<const io::NamedImage> images;
  Unshaded unshaded;
};

Vec3 unitOr(const Vec3& v, const Vec3& otherwise);  // otherwise: where it has no direction

// Of places on one triangle.
InputPlace middleOf(std::span<const InputPlace> places);

class PaintSource {
 public:
  // What the input refers to must outlive the object.
  explicit PaintSource(SourceInput input);
  PaintSource(const PaintSource&) = delete;
  PaintSource& operator=(const PaintSource&) = delete;

  const TriangleMesh& mesh() const { return *input_.mesh; }
  Triangle corners(Index triangle) const;
  const Vec3& faceNormal(Index triangle) const { return faceNormals_[triangle]; }
  // The triangles with a corner at the same place as one of this one's corners.
  std::span<const Index> around(Index corner) const;

  Vec3 position(const InputPlace& place) const;
  Vec3 shadingNormal(const InputPlace& place) const;  // without the normal map; unit
  // The mean over places on one triangle, of which the maps are looked up at each, and all else in
  // the middle.
  Look at(std::span<const InputPlace> places) const;

  // Texels of the finest map of a triangle that lie on it.
  double texels(Index triangle) const;
  // Texels that a triangle takes for the colours of its corners to go over into each other in steps
  // that hardly show.
  double colorTexels(Index triangle) const;
  // Texels of the largest map of a group.
  double largestMap(Index group) const;

 private:
  enum Kind : std::size_t {
    BaseColorMap,
    MetalRoughMap,
    OcclusionMap,
    EmissiveMap,
    NormalMap,
    MapKinds
  };

  // A material's maps, and for each the first that it lies like.
  struct Maps {
    std::array<Texture, MapKinds> textures;
    std::array<std::size_t, MapKinds> like;
  };
  // What the maps say; 1 where there is none.
  using Texels = std::array<Eigen::Vector4d, MapKinds>;

  Maps mapsFor(const io::Material& material) const;

  const io::Material& materialOf(Index triangle) const;
  const Maps& mapsOf(Index triangle) const;
  void linkTriangles();
  void shade();
  void orient();
  Vec2 texcoord(int set, Index vertex) const;
  std::array<Vec2, 3> texcoords(int set, Index triangle) const;
  Texels lookUp(std::span<const InputPlace> places) const;
  Eigen::Vector4d vertexColor(const InputPlace& place) const;
  Vec3 bent(const Vec3& normal, const InputPlace& place, const Eigen::Vector4d& texel) const;

  SourceInput input_;
  io::Material plain_;
  std::vector<Maps> maps_;                   // per group
  std::vector<const Attribute*> texcoords_;  // by their number; null: there are none
  const Attribute* colors_ = nullptr;
  std::vector<Vec3> faceNormals_;
  std::vector<Vec3> normals_;              // per corner
  std::vector<Eigen::Vector4d> tangents_;  // per corner; empty: no normal map
  std::vector<Index> place_;               // per vertex: the first at its place
  std::vector<Index> starts_, around_;     // triangles by place
};

}  // namespace remesher
