// SPDX-License-Identifier: MIT
// A remeshed part before painting: its corners with everything to be written for them, in the
// single precision of files.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "textures/painting/painter.h"
#include "textures/painting/shading.h"
#include "textures/painting/side_finder.h"

namespace remesher {

class NewSurface {
 public:
  // places: per corner, on the source. mesh, places and source must outlive the object.
  NewSurface(const TriangleMesh& mesh, std::span<const InputPlace> places,
             const PaintSource& source);

  const TriangleMesh& mesh() const { return mesh_; }
  FaceKind kind() const { return mesh_.isQuads ? FaceKind::Quads : FaceKind::Triangles; }
  std::span<const Vec3> positions() const { return positions_; }  // per vertex
  Index welded(Index corner) const { return welded_[corner]; }

  // A triangle with its corners' places on the source.
  NewTriangle onSource(Index triangle) const {
    const Index h = 3 * triangle;
    return {{position(h), position(h + 1), position(h + 2)},
            {places_[h], places_[h + 1], places_[h + 2]}};
  }

  // texel: relative to the corner of a square of `size` texels.
  void setTexcoord(Index corner, const Vec2& texel, Index size);
  void setTangent(Index corner, const Eigen::Vector4d& tangent) {
    tangents_[corner] = tangent;
    hasTangents_ = true;
  }
  const Vec3& position(Index corner) const { return positions_[mesh_.indices[corner]]; }
  const Vec3& normal(Index corner) const { return normals_[corner].light; }
  const Vec3& facing(Index corner) const { return normals_[corner].shape; }
  const Vec2& texcoord(Index corner) const { return texcoords_[corner]; }
  CanvasCorner canvasCorner(Index corner, Index size) const;

  // Takes the mesh's own normals, if it has any, for light.
  void takeNormals();

  // Leaves normals and tangents out of the painted mesh: viewers shade its triangles flat.
  void dropNormals() { hasNormals_ = hasTangents_ = false; }
  bool hasNormals() const { return hasNormals_; }

  // Gives all sides of the sharp edges at a vertex one direction to look in, so that they find one
  // place on a surface that is not exactly there.
  void joinFacings();

  // The mesh as it is, its vertices in their order, with normals, texture coordinates and, if any
  // were set, tangents. Copies of vertices whose corners differ follow behind all vertices.
  TriangleMesh paintedInOrder() const;

  // The same with the faces in the drawing order of their places. Vertices are copied
  // where corners differ; the triangles of a quad stay together and share two vertices.
  TriangleMesh painted() const;

 private:
  // For a corner of a quad's second triangle: the same corner of its first, if it has one.
  std::optional<Index> cornerInQuad(Index corner) const;

  const TriangleMesh& mesh_;
  std::span<const InputPlace> places_;
  std::vector<Vec3> positions_;
  std::vector<Index> welded_;
  std::vector<CornerNormals> normals_;
  std::vector<Vec2> texcoords_;
  std::vector<Eigen::Vector4d> tangents_;
  bool hasNormals_ = true, hasTangents_ = false;
};

}  // namespace remesher
