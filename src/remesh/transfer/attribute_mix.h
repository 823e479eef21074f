// SPDX-License-Identifier: MIT
// The original's attributes at any of its points. Each kind is mixed in its own way from the three
// corners of the original triangle, which lies on one side of every seam.
#pragma once

#include <string>
#include <vector>

#include "base/triangle_mesh.h"
#include "original/surface/original_surface.h"

namespace remesher {

class AttributeMix {
 public:
  // chartless: semantics that jump across most edges; of these the nearest corner's value is taken,
  // and normals are computed anew. All arguments must outlive the object.
  AttributeMix(const OriginalSurface& surface, const TriangleMesh& input,
               const std::vector<std::string>& chartless);

  // Appends the values at a point to `values`, one list per attribute of the input and in its
  // order.
  void append(const SurfacePoint& point, std::vector<Attribute>& values) const;

 private:
  // How an attribute is mixed: linearly; linearly and to unit length; as a tangent, kept at right
  // angles to the normal and on its chart's side; from the nearest corner; as skin weights.
  enum class Kind { Linear, Unit, Tangent, SurfaceNormal, Nearest, Skin };

  struct Corners {
    std::array<Index, 3> wedges;
    Vec3 weights;
  };

  Kind kindOf(const Attribute& attribute, const std::vector<std::string>& chartless) const;
  double value(const Attribute& attribute, const Corners& corners, int k) const;
  Vec3 mixedVector(const Attribute& attribute, const Corners& corners) const;
  void appendTangent(std::size_t a, const Corners& corners, const Vec3& normal,
                     std::vector<float>& out) const;
  void appendSkin(const Corners& corners, std::vector<Attribute>& values) const;

  const OriginalSurface& surface_;
  const TriangleMesh& input_;
  std::vector<Kind> kinds_;
  // JOINTS_n and WEIGHTS_n by n: places in the input's list of attributes.
  struct SkinSet {
    std::size_t joints, weights;
  };
  std::vector<SkinSet> skin_;
};

}  // namespace remesher
