// SPDX-License-Identifier: MIT
#include "textures/painting/corner_values.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace remesher {

namespace {

void appendCopy(Attribute& attribute, Index vertex) {
  for (int k = 0; k < attribute.itemSize; ++k)
    attribute.values.push_back(
        attribute.values[std::size_t{vertex} * std::size_t(attribute.itemSize) + std::size_t(k)]);
}

// Gives corners their vertices, copying where their values differ.
class CornerSplitter {
 public:
  CornerSplitter(TriangleMesh& mesh, std::span<const CornerValues> added)
      : mesh_(mesh), added_(added), first_(mesh.positions.size(), kNone) {}

  void run() {
    for (Index h = 0; h < mesh_.indices.size(); ++h) mesh_.indices[h] = vertexFor(h);
  }

  // Per vertex a corner that it has; kNone: no triangle uses it.
  const std::vector<Index>& firstCorners() const { return first_; }

 private:
  Index vertexFor(Index corner) {
    Index v = mesh_.indices[corner];
    if (first_[v] == kNone) {
      first_[v] = corner;
      next_.resize(first_.size(), kNone);
      return v;
    }
    for (;;) {
      if (areAlike(first_[v], corner)) return v;
      if (next_[v] == kNone) break;
      v = next_[v];
    }
    const Index copy = Index(mesh_.positions.size());
    mesh_.positions.push_back(Vec3(mesh_.positions[v]));
    for (Attribute& attribute : mesh_.attributes) appendCopy(attribute, v);
    next_[v] = copy;
    first_.push_back(corner);
    next_.push_back(kNone);
    return copy;
  }

  bool areAlike(Index a, Index b) const {
    return std::all_of(added_.begin(), added_.end(), [&](const CornerValues& values) {
      const auto at = [&](Index corner) {
        return values.values.begin() + std::ptrdiff_t(corner) * values.itemSize;
      };
      return std::equal(at(a), at(a) + values.itemSize, at(b));
    });
  }

  TriangleMesh& mesh_;
  std::span<const CornerValues> added_;
  std::vector<Index> first_;
  std::vector<Index> next_;  // the next copy of the same vertex
};

}  // namespace

TriangleMesh withCorners(TriangleMesh mesh, std::span<const CornerValues> added) {
  std::erase_if(mesh.attributes, [&](const Attribute& attribute) {
    return std::any_of(added.begin(), added.end(), [&](const CornerValues& values) {
      return values.semantic == attribute.semantic;
    });
  });
  CornerSplitter splitter(mesh, added);
  splitter.run();
  for (const CornerValues& values : added) {
    const std::size_t size = std::size_t(values.itemSize);
    Attribute made{values.semantic, values.itemSize, {}};
    made.values.assign(size * mesh.positions.size(), 0);
    // A vertex without triangles gets a direction of length 1, as files require.
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      const Index corner = splitter.firstCorners()[v];
      if (corner == kNone)
        made.values[size * v + size - 1] = 1;
      else
        std::copy_n(values.values.begin() + std::ptrdiff_t(size * corner), size,
                    made.values.begin() + std::ptrdiff_t(size * v));
    }
    mesh.attributes.push_back(std::move(made));
  }
  return mesh;
}

}  // namespace remesher
