// SPDX-License-Identifier: MIT
#include "remesh/schemes/attribute_lengths.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/triangle.h"
#include "remesh/schemes/bent_skin.h"

namespace remesher {

namespace {

// A change from no colour to full colour counts as a hundredth of the model's size.
constexpr double kAll = 0.01;
// A shift of a texture along the surface counts as so much of a distance away from it.
constexpr double kAlong = 0.25;
// What moves only in other poses and shapes counts as so much of a distance at rest.
constexpr double kOfDistance = 0.1;

bool startsWith(const Attribute& attribute, std::string_view name) {
  return attribute.semantic.starts_with(name);
}

double texelLength(const TriangleMesh& input, const Attribute& uv) {
  double surface = 0, chart = 0;
  const auto at = [&](Index v) {
    const float* value = &uv.values[std::size_t(v) * uv.itemSize];
    return Vec3(value[0], value[1], 0);
  };
  for (std::size_t t = 0; t + 2 < input.indices.size(); t += 3) {
    const Index a = input.indices[t], b = input.indices[t + 1], c = input.indices[t + 2];
    surface += area(input.positions[a], input.positions[b], input.positions[c]);
    chart += area(at(a), at(b), at(c));
  }
  return chart > 0 ? std::sqrt(surface / chart) : 0;
}

double diagonalOf(const TriangleMesh& input) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : input.positions) box.extend(p);
  return box.diagonal().norm();
}

double lengthOf(const TriangleMesh& input, const Attribute& attribute) {
  if (startsWith(attribute, "NORMAL") || startsWith(attribute, "TANGENT") ||
      startsWith(attribute, "JOINTS"))
    return 0;
  if (attribute.semantic == "WEIGHTS_0" && BentSkin::has(input)) return 0;
  if (startsWith(attribute, "TARGET_"))
    return attribute.semantic.ends_with("/POSITION") ? kOfDistance : 0;
  if (startsWith(attribute, "TEXCOORD")) return kAlong * texelLength(input, attribute);
  return kAll * diagonalOf(input);
}

}  // namespace

bool haveSameLook(const TriangleMesh& input, Index a, Index b) {
  return haveSameAttributes(input, a, b, [](std::string_view semantic) {
    return !semantic.starts_with("NORMAL") && !semantic.starts_with("TANGENT");
  });
}

KeptAttributes attributesAsLengths(const BuiltMesh& original, const TriangleMesh& input) {
  KeptAttributes kept{original.wedges, 0, {}};
  std::vector<std::pair<const Attribute*, double>> lengths;
  for (const Attribute& attribute : input.attributes)
    if (const double length = lengthOf(input, attribute); length > 0) {
      lengths.emplace_back(&attribute, length);
      kept.itemSize += std::size_t(attribute.itemSize);
    }
  std::optional<BentSkin> skin;
  if (BentSkin::has(input)) {
    skin.emplace(input);
    kept.itemSize += 3 * std::size_t{BentSkin::kPoses};
  }
  for (std::size_t v = 0; v < input.positions.size(); ++v) {
    for (const auto& [attribute, length] : lengths)
      for (int k = 0; k < attribute->itemSize; ++k)
        kept.values.push_back(length * attribute->values[v * attribute->itemSize + k]);
    for (int pose = 0; skin && pose < BentSkin::kPoses; ++pose)
      for (const double way : skin->movement(v, pose)) kept.values.push_back(kOfDistance * way);
  }
  // All wedges of a vertex that look the same become one.
  const HalfedgeMesh& m = original.mesh;
  for (Index i = 0; i < m.vertexCapacity(); ++i) {
    std::vector<Index> looks;
    m.forEachOutgoing(Vertex(i), [&](Halfedge h) {
      Index& wedge = kept.wedges[h];
      const auto look = std::find_if(looks.begin(), looks.end(), [&](Index other) {
        return haveSameLook(input, wedge, other);
      });
      if (look == looks.end())
        looks.push_back(wedge);
      else
        wedge = *look;
    });
  }
  return kept;
}

}  // namespace remesher
