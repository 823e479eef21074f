// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/quad_patch.h"

#include <algorithm>
#include <map>

#include "remesh/quads/mesh/quad_parts.h"

namespace remesher {

Index QuadPatch::add(const Placement& place) {
  mesh.vertices.push_back(place);
  outer.push_back(kNone);
  isRim.push_back(0);
  return Index(outer.size() - 1);
}

void QuadPatch::dropUnusedVertices() {
  std::vector<char> isUsed(outer.size(), 0);
  for (const Four<Index>& quad : mesh.quads)
    for (const Index v : quad) isUsed[v] = 1;
  std::size_t kept = 0;
  for (std::size_t v = 0; v < isUsed.size(); ++v) {
    if (!isUsed[v]) continue;
    outer[kept] = outer[v];
    isRim[kept++] = isRim[v];
  }
  outer.resize(kept);
  isRim.resize(kept);
  remesher::dropUnusedVertices(mesh);
}

std::vector<Index> quadsNear(const QuadSides& sides, const QuadMesh& mesh, Index quad) {
  std::vector<Index> found = {quad};
  std::size_t begin = 0;
  for (int ring = 0; ring < 2; ++ring) {
    const std::size_t end = found.size();
    for (; begin < end; ++begin)
      for (const Index v : mesh.quads[found[begin]])
        sides.forEachOutgoing(v, [&](Index side) {
          if (std::find(found.begin(), found.end(), side / 4) == found.end())
            found.push_back(side / 4);
        });
  }
  return found;
}

QuadPatch patchOf(const QuadMesh& mesh, const QuadSides& sides, const std::vector<Index>& quads) {
  QuadPatch patch;
  std::map<Index, Index> number;
  std::vector<int> around;
  for (const Index q : quads) {
    Four<Index> corners{};
    for (std::size_t i = 0; i < 4; ++i) {
      const Index v = mesh.quads[q][i];
      const auto [known, isNew] = number.try_emplace(v, Index(patch.outer.size()));
      if (isNew) {
        patch.add(mesh.vertices[v]);
        patch.outer.back() = v;
        around.push_back(0);
      }
      corners[i] = known->second;
      ++around[known->second];
    }
    patch.mesh.quads.push_back(corners);
    patch.mesh.curves.push_back(mesh.curves[q]);
  }
  for (std::size_t v = 0; v < around.size(); ++v)
    patch.isRim[v] = around[v] != sides.quadsAround(patch.outer[v]);
  return patch;
}

void putBack(QuadMesh& mesh, const QuadPatch& patch) {
  std::vector<Index> number = patch.outer;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNone) {
      number[v] = Index(mesh.vertices.size());
      mesh.vertices.push_back(patch.mesh.vertices[v]);
    } else {
      mesh.vertices[number[v]] = patch.mesh.vertices[v];
    }
  }
  for (const auto& [a, b, c, d] : patch.mesh.quads)
    mesh.quads.push_back({number[a], number[b], number[c], number[d]});
  mesh.curves.insert(mesh.curves.end(), patch.mesh.curves.begin(), patch.mesh.curves.end());
}

}  // namespace remesher
