// SPDX-License-Identifier: MIT
// The attributes at any point of a triangle. Each kind is mixed in its own way from the three
// corners, which lie on one side of every seam.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

class AttributeMix {
 public:
  struct Point {
    std::array<Index, 3> vertices;  // of the input: the triangle's corners
    Vec3 weights;                   // barycentric
    Vec3 normal = Vec3::Zero();     // of the surface there; only read if needsNormals()
  };

  // chartless: semantics that jump across most edges; of these the nearest corner's value is taken,
  // and normals are the surface's. The input must outlive the object.
  explicit AttributeMix(const TriangleMesh& input, const std::vector<std::string>& chartless = {});

  bool needsNormals() const { return needsNormals_; }

  // Appends the values at a point to `values`, one list per attribute of the input and in its
  // order; these may be the input's own.
  void append(const Point& point, std::vector<Attribute>& values) const;

 private:
  // How an attribute is mixed: linearly; linearly and to unit length; as a tangent, kept at right
  // angles to the normal and on its chart's side; from the nearest corner; as skin weights.
  enum class Kind { Linear, Unit, Tangent, SurfaceNormal, Nearest, Skin };

  Kind kindOf(const Attribute& attribute, const std::vector<std::string>& chartless) const;
  double value(const Attribute& attribute, const Point& point, int k) const;
  Vec3 mixedVector(const Attribute& attribute, const Point& point) const;
  void appendTangent(std::size_t a, const Point& point, const Vec3& normal,
                     std::vector<float>& out) const;
  void appendSkin(const Point& point, std::vector<Attribute>& values) const;

  const TriangleMesh& input_;
  std::vector<Kind> kinds_;
  bool needsNormals_ = false;
  // JOINTS_n and WEIGHTS_n by n: places in the input's list of attributes.
  struct SkinSet {
    std::size_t joints, weights;
  };
  std::vector<SkinSet> skin_;
};

}  // namespace remesher
