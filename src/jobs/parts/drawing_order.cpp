// SPDX-License-Identifier: MIT
#include "jobs/parts/drawing_order.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/triangle_tree.h"

namespace remesher {

namespace {

bool isSeenThrough(const io::Part& part) {
  return std::any_of(part.groups.begin(), part.groups.end(),
                     [](const io::GroupInfo& group) { return !group.look.isOpaque; });
}

// Per face the original's triangle at its middle.
std::vector<Index> underFaces(const TriangleMesh& mesh, std::size_t corners,
                              const TriangleMesh& original) {
  const TriangleTree tree(original.positions, original.indices);
  std::vector<Index> under;
  Index last = kNone;
  for (std::size_t h = 0; h < mesh.indices.size(); h += corners) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < corners; ++k) sum += mesh.positions[mesh.indices[h + k]];
    last = tree.nearest(sum / double(corners), last).triangle;
    under.push_back(last);
  }
  return under;
}

void sortFaces(TriangleMesh& mesh, const TriangleMesh& original) {
  const std::size_t corners = mesh.isQuads ? 6 : 3;
  const std::vector<Index> under = underFaces(mesh, corners, original);
  std::vector<Index> order(under.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return under[a] < under[b]; });
  const std::vector<Index> indices = std::exchange(mesh.indices, {}),
                           groups = std::exchange(mesh.groups, {});
  for (const Index face : order)
    for (std::size_t h = corners * face; h < corners * (face + 1); ++h) {
      mesh.indices.push_back(indices[h]);
      if (h % 3 == 0 && !groups.empty()) mesh.groups.push_back(groups[h / 3]);
    }
}

}  // namespace

void keepDrawingOrder(std::vector<io::Part>& made, const std::vector<io::Part>& originals) {
  for (std::size_t i = 0; i < made.size(); ++i)
    if (isSeenThrough(originals[i]) && !originals[i].mesh.indices.empty())
      sortFaces(made[i].mesh, originals[i].mesh);
}

}  // namespace remesher
