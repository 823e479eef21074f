// SPDX-License-Identifier: MIT
#include "mesh/canonical_order.h"

#include <algorithm>
#include <array>
#include <span>
#include <tuple>
#include <utility>

#include "base/sort_pairs.h"
#include "mesh/space_order.h"

namespace remesher {
namespace {

using FloatPoint = std::array<float, 3>;

std::vector<FloatPoint> floatsOf(const std::vector<Vec3>& positions) {
  std::vector<FloatPoint> floats;
  floats.reserve(positions.size());
  for (const Vec3& position : positions) {
    floats.push_back({float(position.x()), float(position.y()), float(position.z())});
  }
  return floats;
}

// Compares vertices by place, then by the values of the attributes: below 0 if a comes first, 0 if
// they are just the same.
int compared(const TriangleMesh& mesh, Index a, Index b) {
  const Vec3 &p = mesh.positions[a], &q = mesh.positions[b];
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (p[axis] != q[axis]) return p[axis] < q[axis] ? -1 : 1;
  for (const Attribute& attribute : mesh.attributes) {
    const auto size = std::size_t(attribute.itemSize);
    for (std::size_t k = 0; k < size; ++k) {
      const float x = attribute.values[a * size + k], y = attribute.values[b * size + k];
      if (x != y) return x < y ? -1 : 1;
    }
  }
  return 0;
}

std::vector<Index> verticesInOrder(const TriangleMesh& mesh) {
  const std::vector<FloatPoint> floats = floatsOf(mesh.positions);
  std::vector<Index> order = orderInSpace(floats);
  const auto isBefore = [&](Index a, Index b) {
    const int side = compared(mesh, a, b);
    return side < 0 || (side == 0 && a < b);
  };
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && floats[order[end]] == floats[order[begin]]) ++end;
    std::sort(order.begin() + std::ptrdiff_t(begin), order.begin() + std::ptrdiff_t(end), isBefore);
  }
  return order;
}

// A unit that is turned and ordered as one: a triangle, or both halves of a quad.
struct OrderedFace {
  std::array<Index, 4> corners;  // in the new order of vertices, the least first; kNone: no fourth
  Index group;
  Index number;  // of the given faces
  std::uint8_t turn;

  auto key() const { return std::tie(corners, group, number); }
};

OrderedFace leastFirst(std::span<const Index> corners, std::size_t step) {
  OrderedFace face{{kNone, kNone, kNone, kNone}, 0, 0, 0};
  std::copy(corners.begin(), corners.end(), face.corners.begin());
  std::array<Index, 4> best = face.corners;
  for (std::size_t turn = step; turn < corners.size(); turn += step) {
    std::array<Index, 4> other = face.corners;
    std::rotate_copy(corners.begin(), corners.begin() + std::ptrdiff_t(turn), corners.end(),
                     other.begin());
    if (other < best) best = other, face.turn = std::uint8_t(turn);
  }
  face.corners = best;
  return face;
}

// A quad (a, b, c), (a, c, d) may begin at a or, cut in the same way, at c.
std::vector<OrderedFace> facesInOrder(const TriangleMesh& mesh, const std::vector<Index>& numbers) {
  const std::size_t halves = mesh.isQuads ? 2 : 1;
  std::vector<OrderedFace> faces;
  faces.reserve(mesh.triangleCount() / halves);
  for (std::size_t t = 0; t < mesh.triangleCount(); t += halves) {
    const auto at = [&](std::size_t k) { return numbers[mesh.indices[3 * t + k]]; };
    const std::array<Index, 4> corners = {at(0), at(1), at(2), mesh.isQuads ? at(5) : kNone};
    faces.push_back(leastFirst(std::span(corners).first(mesh.isQuads ? 4 : 3), halves));
    faces.back().group = mesh.groups.empty() ? 0 : mesh.groups[t];
    faces.back().number = Index(t / halves);
  }
  sortInBuckets(
      faces, numbers.size(), [](const OrderedFace& face) { return face.corners.front(); },
      [](const OrderedFace& a, const OrderedFace& b) { return a.key() < b.key(); });
  return faces;
}

// A quad (a, b, c), (a, c, d) that begins at its third corner is (c, d, a), (c, a, b).
void addQuad(CanonicalOrder& order, const OrderedFace& face) {
  const Index first = 2 * face.number;
  if (face.turn == 0) {
    order.triangles.insert(order.triangles.end(), {first, first + 1});
    order.turns.insert(order.turns.end(), {0, 0});
  } else {
    order.triangles.insert(order.triangles.end(), {first + 1, first});
    order.turns.insert(order.turns.end(), {1, 2});
  }
}

}  // namespace

CanonicalOrder canonicalOrder(const TriangleMesh& mesh) {
  CanonicalOrder order;
  order.vertices = verticesInOrder(mesh);
  order.numbers.resize(order.vertices.size());
  for (Index v = 0; v < order.vertices.size(); ++v) {
    const bool isSame = v > 0 && compared(mesh, order.vertices[v - 1], order.vertices[v]) == 0;
    order.numbers[order.vertices[v]] = isSame ? order.numbers[order.vertices[v - 1]] : v;
  }
  for (const OrderedFace& face : facesInOrder(mesh, order.numbers)) {
    if (mesh.isQuads) {
      addQuad(order, face);
    } else {
      order.triangles.push_back(face.number);
      order.turns.push_back(face.turn);
    }
  }
  return order;
}

TriangleMesh inOrder(const TriangleMesh& mesh, const CanonicalOrder& order) {
  TriangleMesh made;
  made.isSingle = mesh.isSingle, made.isQuads = mesh.isQuads;
  made.frame = mesh.frame, made.steps = mesh.steps;
  for (const Index v : order.vertices) made.positions.push_back(mesh.positions[v]);
  for (std::size_t t = 0; t < order.triangles.size(); ++t) {
    const std::size_t first = 3 * std::size_t{order.triangles[t]};
    for (std::size_t k = 0; k < 3; ++k)
      made.indices.push_back(order.numbers[mesh.indices[first + (k + order.turns[t]) % 3]]);
    if (!mesh.groups.empty()) made.groups.push_back(mesh.groups[order.triangles[t]]);
  }
  for (const Attribute& attribute : mesh.attributes)
    made.attributes.push_back(valuesOf(attribute, order.vertices));
  return made;
}

}  // namespace remesher
