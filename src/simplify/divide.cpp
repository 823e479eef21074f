// SPDX-License-Identifier: MIT
#include "simplify/divide.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "geometry/triangle.h"

namespace remesher {

namespace {

struct Side {
  double length;  // of the edge, negative: the longest come first
  Index low, high, group, triangle;

  auto key() const { return std::tie(length, low, high, group, triangle); }
  bool operator<(const Side& other) const { return key() < other.key(); }
  bool isAt(const Side& other) const { return low == other.low && high == other.high; }
};

std::vector<Side> sidesOf(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  for (Index i = 0; i < mesh.indices.size(); ++i) {
    const Index t = i / 3, a = mesh.indices[i], b = mesh.indices[3 * t + (i + 1) % 3];
    sides.push_back({-distance(mesh.positions[a], mesh.positions[b]), std::min(a, b),
                     std::max(a, b), mesh.groups.empty() ? 0 : mesh.groups[t], t});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

// Directions are those of the first end.
void addMiddle(TriangleMesh& mesh, const Side& edge) {
  mesh.positions.push_back((mesh.positions[edge.low] + mesh.positions[edge.high]) / 2);
  for (Attribute& attribute : mesh.attributes) {
    const auto size = std::size_t(attribute.itemSize);
    const bool isMixed = attribute.semantic != "NORMAL" && attribute.semantic != "TANGENT";
    for (std::size_t k = 0; k < size; ++k) {
      const float first = attribute.values[edge.low * size + k];
      const float second = attribute.values[edge.high * size + k];
      attribute.values.push_back(isMixed ? (first + second) / 2 : first);
    }
  }
}

void divide(TriangleMesh& mesh, const Side& side) {
  const Index middle = Index(mesh.positions.size() - 1);
  for (Index i = 3 * side.triangle; i < 3 * side.triangle + 3; ++i) {
    const Index corner = mesh.indices[i];
    mesh.indices.push_back(corner == side.low ? middle : corner);
    if (corner == side.high) mesh.indices[i] = middle;
  }
  if (!mesh.groups.empty()) mesh.groups.push_back(side.group);
}

// Whether the side and the next one are the two sides of an edge inside a group.
bool isInside(const std::vector<Side>& sides, std::size_t i) {
  const Side &one = sides[i], &other = sides[i + 1];
  const bool hasThird =
      (i > 0 && sides[i - 1].isAt(one)) || (i + 2 < sides.size() && sides[i + 2].isAt(one));
  return one.isAt(other) && one.group == other.group && !hasThird;
}

// Divides the longest edges, at most so many, and at most one of each triangle. Returns how many.
std::size_t divideOnce(TriangleMesh& mesh, std::size_t most) {
  const std::vector<Side> sides = sidesOf(mesh);
  std::vector<char> isDivided(mesh.triangleCount(), 0);
  std::size_t divided = 0;
  for (std::size_t i = 0; i + 1 < sides.size() && divided < most; ++i) {
    const Side &one = sides[i], &other = sides[i + 1];
    char &first = isDivided[one.triangle], &second = isDivided[other.triangle];
    if (first || second || !isInside(sides, i)) continue;
    first = second = 1;
    addMiddle(mesh, one);
    divide(mesh, one);
    divide(mesh, other);
    ++divided;
  }
  return divided;
}

}  // namespace

bool divideEdges(TriangleMesh& mesh, std::size_t vertices) {
  for (const Attribute& attribute : mesh.attributes)
    if (attribute.semantic.starts_with("JOINTS")) return false;
  while (vertices > 0) {
    const std::size_t divided = divideOnce(mesh, vertices);
    if (divided == 0) return false;
    vertices -= divided;
  }
  return true;
}

}  // namespace remesher
