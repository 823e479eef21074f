// SPDX-License-Identifier: MIT
#include "original/surface/original_tree.h"

#include <cmath>
#include <utility>

namespace remesher {

// Triangles are listed in the order of the faces, so that they have the faces' numbers.
void OriginalTree::build() {
  const BuiltMesh& built = surface_.built();
  const auto listed =
      built.isInSpaceOrder ? TriangleTree::Listed::SideBySide : TriangleTree::Listed::Anyhow;
  if (input_)
    tree_.emplace(input_->positions, built.wedges.values(), listed);
  else
    tree_.emplace(built.positions.values(), built.mesh.triangles(), listed);
}

OriginalTree::Nearest OriginalTree::nearest(const Vec3& p, Face start) {
  if (!tree_) build();
  const TriangleTree::Nearest nearest = tree_->tree.nearest(p, start.index);
  return {std::sqrt(nearest.squaredDistance), nearest.looked};
}

std::optional<ListedTree> OriginalTree::ofInput() {
  const BuiltMesh& built = surface_.built();
  if (!input_ || built.triangles.size() + built.lines != input_->triangleCount()) return {};
  return std::exchange(tree_, std::nullopt);
}

}  // namespace remesher
