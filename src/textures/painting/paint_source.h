// SPDX-License-Identifier: MIT
// The original as a painter sees it: at any place its colours, its roughness and so on, and the
// normal that light takes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/input_place.h"
#include "base/triangle_mesh.h"
#include "geometry/triangle.h"
#include "mesh/handles.h"
#include "textures/painting/texture.h"

namespace remesher {

struct Look {
  Eigen::Vector4d baseColor = Eigen::Vector4d::Zero();  // linear light, and alpha
  Vec3 emissive = Vec3::Zero();                         // linear light
  Vec3 surface = Vec3::Zero();                          // occlusion, roughness, metal
  Vec3 normal = Vec3::Zero();                           // unit
};

// How a mesh without normals is shaded.
enum class Unshaded { Flat, Smooth };

struct SourceInput {
  const TriangleMesh* mesh;
  std::vector<io::Material> materials;  // per group
  std::span<const io::NamedImage> images;
  Unshaded unshaded;
};

Vec3 unitOr(const Vec3& v, const Vec3& otherwise);  // otherwise: returned if v has no direction

// The mean of places on one triangle.
InputPlace middleOf(std::span<const InputPlace> places);

class PaintSource {
 public:
  // The objects that the input refers to must outlive this one.
  explicit PaintSource(SourceInput input);
  PaintSource(const PaintSource&) = delete;
  PaintSource& operator=(const PaintSource&) = delete;

  const TriangleMesh& mesh() const { return *input_.mesh; }
  Triangle corners(InputTriangle triangle) const;
  const Vec3& faceNormal(InputTriangle triangle) const { return faceNormals_[triangle]; }
  // The triangles around the place of the triangle's corner k.
  std::span<const InputTriangle> around(InputTriangle triangle, std::size_t k) const;

  // Whether each triangle is shaded as a flat facet, without a map of normals.
  bool isFaceted() const;

  Vec3 position(const InputPlace& place) const;
  Vec3 shadingNormal(const InputPlace& place) const;  // without the normal map; unit
  // The mean look over places on one triangle. Maps are looked up at each place, all else in the
  // middle of the places.
  Look at(std::span<const InputPlace> places) const;

  // The number of texels of a triangle's finest map that lie on it.
  double texels(InputTriangle triangle) const;
  // The number of texels in which the colours of a triangle's corners blend in hardly visible
  // steps.
  double colorTexels(InputTriangle triangle) const;
  // The number of texels of a group's largest map.
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

  // A material's maps, and for each the first map with the same texels (see liesLike).
  struct Maps {
    std::array<Texture, MapKinds> textures;
    std::array<std::size_t, MapKinds> like;
  };
  // The values of the maps; 1 where there is no map.
  using Texels = std::array<Eigen::Vector4d, MapKinds>;

  Maps mapsFor(const io::Material& material) const;

  const io::Material& materialOf(InputTriangle triangle) const;
  const Maps& mapsOf(InputTriangle triangle) const;
  void linkTriangles();
  void shade();
  void orient();
  Vec2 texcoord(int set, Index vertex) const;
  std::array<Vec2, 3> texcoords(int set, InputTriangle triangle) const;
  Texels lookUp(std::span<const InputPlace> places) const;
  Eigen::Vector4d vertexColor(const InputPlace& place) const;
  Vec3 bent(const Vec3& normal, const InputPlace& place, const Eigen::Vector4d& texel) const;

  SourceInput input_;
  io::Material plain_;
  std::vector<Maps> maps_;                   // per group
  std::vector<const Attribute*> texcoords_;  // by set number; null: the mesh has none
  const Attribute* colors_ = nullptr;
  HandleData<InputTriangle, Vec3> faceNormals_;
  std::vector<Vec3> normals_;              // per corner
  std::vector<Eigen::Vector4d> tangents_;  // per corner; empty: no normal map
  std::vector<Index> place_;               // per vertex: the first at its place
  std::vector<Index> starts_;              // by place, in around_
  std::vector<InputTriangle> around_;      // triangles by place
};

}  // namespace remesher
