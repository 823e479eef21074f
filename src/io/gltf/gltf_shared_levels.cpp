// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_shared_levels.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace remesher::io {
namespace {

// Of the levels' vertices, one in so many may be their own: with more than that, those that they
// share would be fewer than those.
constexpr std::size_t kFewOwn = 2;

bool areAlike(const TriangleMesh& a, const TriangleMesh& b) {
  return a.isQuads == b.isQuads &&
         std::equal(a.attributes.begin(), a.attributes.end(), b.attributes.begin(),
                    b.attributes.end(), [](const Attribute& x, const Attribute& y) {
                      return x.semantic == y.semantic && x.itemSize == y.itemSize;
                    });
}

struct Vertex {
  const TriangleMesh* mesh;
  Index number;  // in the mesh
  Index place;   // among the vertices of all levels
};

// Below, above or equal: −1, 1, 0.
int compared(const Vertex& a, const Vertex& b) {
  const Vec3 &p = a.mesh->positions[a.number], &q = b.mesh->positions[b.number];
  for (int k = 0; k < 3; ++k)
    if (p[k] != q[k]) return p[k] < q[k] ? -1 : 1;
  for (std::size_t i = 0; i < a.mesh->attributes.size(); ++i) {
    const auto size = std::size_t(a.mesh->attributes[i].itemSize);
    const float* const x = &a.mesh->attributes[i].values[size * a.number];
    const float* const y = &b.mesh->attributes[i].values[size * b.number];
    for (std::size_t k = 0; k < size; ++k)
      if (x[k] != y[k]) return x[k] < y[k] ? -1 : 1;
  }
  return 0;
}

std::vector<Vertex> verticesOf(const TriangleMesh& finest,
                               const std::vector<TriangleMesh>& levels) {
  std::vector<Vertex> all;
  const auto add = [&](const TriangleMesh& mesh) {
    for (Index v = 0; v < mesh.positions.size(); ++v) all.push_back({&mesh, v, Index(all.size())});
  };
  add(finest);
  for (const TriangleMesh& level : levels) add(level);
  return all;
}

// Per vertex the first one that equals it; vertices of the finest level stay as they are.
std::vector<Index> firstsOf(std::vector<Vertex> all, std::size_t finest) {
  std::vector<Index> firsts(all.size());
  std::sort(all.begin(), all.end(), [](const Vertex& a, const Vertex& b) {
    const int order = compared(a, b);
    return order != 0 ? order < 0 : a.place < b.place;
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool isCopy = i > 0 && all[i].place >= finest && compared(all[i - 1], all[i]) == 0;
    firsts[all[i].place] = isCopy ? firsts[all[i - 1].place] : all[i].place;
  }
  return firsts;
}

void appendVertex(TriangleMesh& to, const Vertex& vertex) {
  to.positions.push_back(vertex.mesh->positions[vertex.number]);
  for (std::size_t i = 0; i < to.attributes.size(); ++i) {
    const Attribute& from = vertex.mesh->attributes[i];
    const auto begin = from.values.begin() + std::ptrdiff_t(vertex.number) * from.itemSize;
    to.attributes[i].values.insert(to.attributes[i].values.end(), begin, begin + from.itemSize);
  }
}

void appendTriangles(TriangleMesh& to, const TriangleMesh& from, std::span<const Index> numbers,
                     Index firstGroup) {
  for (const Index v : from.indices) to.indices.push_back(numbers[v]);
  for (std::size_t t = 0; t < from.triangleCount(); ++t)
    to.groups.push_back(firstGroup + (from.groups.empty() ? 0 : from.groups[t]));
}

}  // namespace

std::optional<TriangleMesh> sharedLevels(const TriangleMesh& finest,
                                         const std::vector<TriangleMesh>& levels, Index groups) {
  const auto isLike = [&](const TriangleMesh& level) { return areAlike(finest, level); };
  if (levels.empty() || !std::all_of(levels.begin(), levels.end(), isLike)) return {};
  const std::vector<Vertex> all = verticesOf(finest, levels);
  const std::vector<Index> firsts = firstsOf(all, finest.positions.size());
  std::size_t own = 0;
  for (std::size_t i = finest.positions.size(); i < all.size(); ++i) own += firsts[i] == i;
  if (own > (all.size() - finest.positions.size()) / kFewOwn) return {};
  TriangleMesh shared = finest;
  shared.indices.clear();
  shared.groups.clear();
  std::vector<Index> numbers(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool isOwn = firsts[i] == i && i >= finest.positions.size();
    numbers[i] = firsts[i] < i ? numbers[firsts[i]] : Index(isOwn ? shared.positions.size() : i);
    if (isOwn) appendVertex(shared, all[i]);
  }
  std::span<const Index> left = numbers;
  appendTriangles(shared, finest, left, 0);
  left = left.subspan(finest.positions.size());
  for (std::size_t k = 0; k < levels.size(); ++k) {
    appendTriangles(shared, levels[k], left, Index(k + 1) * groups);
    left = left.subspan(levels[k].positions.size());
  }
  return shared;
}

}  // namespace remesher::io
