// SPDX-License-Identifier: MIT
// What remeshing has made of a part, on its way to being painted: its corners with all that is to
// be written of them, in the single precision that files have.
#pragma once

#include <span>
#include <vector>

#include "textures/painting/painter.h"
#include "textures/painting/shading.h"
#include "textures/painting/side_finder.h"

namespace remesher {

class NewSurface {
 public:
  // places: per corner, on the source. Both must outlive the object, and the mesh, too.
  NewSurface(const TriangleMesh& mesh, std::span<const InputPlace> places,
             const PaintSource& source);

  const TriangleMesh& mesh() const { return mesh_; }
  std::span<const Vec3> positions() const { return positions_; }  // per vertex
  Index welded(Index corner) const { return welded_[corner]; }

  // A triangle, with where its corners are on the source.
  NewTriangle onSource(Index triangle) const {
    const Index h = 3 * triangle;
    return {{position(h), position(h + 1), position(h + 2)},
            {places_[h], places_[h + 1], places_[h + 2]}};
  }

  // texel: from the corner of a square of so many.
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

  // The mesh with normals, texture coordinates and, if any were set, tangents; a vertex in as many
  // copies as they need.
  TriangleMesh painted() const;

 private:
  const TriangleMesh& mesh_;
  std::span<const InputPlace> places_;
  std::vector<Vec3> positions_;
  std::vector<Index> welded_;
  std::vector<CornerNormals> normals_;
  std::vector<Vec2> texcoords_;
  std::vector<Eigen::Vector4d> tangents_;
  bool hasTangents_ = false;
};

}  // namespace remesher
