// SPDX-License-Identifier: MIT
// Squares to paint from.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "textures/painting/paint_source.h"

namespace remesher::test {

enum class Facing { Up, Down };

// Two triangles over the unit square at a height.
inline void addSquare(TriangleMesh& mesh, double z, Facing facing) {
  const Index first = Index(mesh.positions.size());
  for (const auto& [x, y] : {std::pair{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}})
    mesh.positions.emplace_back(x, y, z);
  const std::array<Index, 6> corners = {0, 1, 2, 0, 2, 3};
  for (const Index c : corners) mesh.indices.push_back(first + c);
  if (facing == Facing::Up) return;
  for (std::size_t i = mesh.indices.size() - 6; i < mesh.indices.size(); i += 3)
    std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
}

inline std::unique_ptr<PaintSource> sourceOf(const TriangleMesh& mesh,
                                             std::vector<io::Material> materials = {},
                                             std::span<const io::NamedImage> images = {}) {
  return std::make_unique<PaintSource>(
      SourceInput{&mesh, std::move(materials), images, Unshaded::Flat});
}

}  // namespace remesher::test
