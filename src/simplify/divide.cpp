// SPDX-License-Identifier: MIT
#include "simplify/divide.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "geometry/triangle.h"

namespace remesher {

namespace {

using Ends = std::pair<Index, Index>;  // of an edge, the lower one first

class Division {
 public:
  explicit Division(TriangleMesh& mesh) : mesh_(mesh) {
    for (Index t = 0; t < mesh.triangleCount(); ++t) join(t);
  }

  bool run(std::size_t vertices) {
    for (; vertices > 0 && !longest_.empty(); --vertices) divide(longest_.rbegin()->second);
    return vertices == 0;
  }

 private:
  Ends edge(Index t, Index k) const {
    const Index a = mesh_.indices[3 * t + k], b = mesh_.indices[3 * t + (k + 1) % 3];
    return std::minmax(a, b);
  }

  Index groupOf(Index t) const { return mesh_.groups.empty() ? 0 : mesh_.groups[t]; }

  bool isInside(const std::vector<Index>& sides) const {
    return sides.size() == 2 && groupOf(sides[0]) == groupOf(sides[1]);
  }

  double lengthOf(const Ends& ends) const {
    return distance(mesh_.positions[ends.first], mesh_.positions[ends.second]);
  }

  void join(Index t) {
    for (Index k = 0; k < 3; ++k) {
      const Ends ends = edge(t, k);
      std::vector<Index>& sides = sides_[ends];
      sides.push_back(t);
      if (isInside(sides)) longest_.emplace(lengthOf(ends), ends);
    }
  }

  void part(Index t) {
    for (Index k = 0; k < 3; ++k) {
      const Ends ends = edge(t, k);
      std::vector<Index>& sides = sides_[ends];
      if (isInside(sides)) longest_.erase({lengthOf(ends), ends});
      sides.erase(std::find(sides.begin(), sides.end(), t));
    }
  }

  Index middleOf(const Ends& ends) {
    const auto [a, b] = ends;
    mesh_.positions.push_back((mesh_.positions[a] + mesh_.positions[b]) / 2);
    for (Attribute& attribute : mesh_.attributes) {
      const auto size = std::size_t(attribute.itemSize);
      Eigen::VectorXf value(attribute.itemSize);
      for (std::size_t i = 0; i < size; ++i)
        value[Eigen::Index(i)] =
            (attribute.values[a * size + i] + attribute.values[b * size + i]) / 2;
      const bool isDirection = attribute.semantic == "NORMAL" || attribute.semantic == "TANGENT";
      if (isDirection) value.head(3).normalize();
      attribute.values.insert(attribute.values.end(), value.begin(), value.end());
    }
    return Index(mesh_.positions.size() - 1);
  }

  void divide(const Ends ends) {
    const std::vector<Index> sides = sides_[ends];
    for (const Index t : sides) part(t);
    const Index middle = middleOf(ends);
    for (const Index t : sides) {
      const auto other = Index(mesh_.triangleCount());
      for (Index k = 0; k < 3; ++k) {
        const Index corner = mesh_.indices[3 * t + k];
        mesh_.indices.push_back(corner == ends.first ? middle : corner);
        if (corner == ends.second) mesh_.indices[3 * t + k] = middle;
      }
      if (!mesh_.groups.empty()) mesh_.groups.push_back(groupOf(t));
      join(t);
      join(other);
    }
  }

  TriangleMesh& mesh_;
  std::map<Ends, std::vector<Index>> sides_;   // the triangles at each edge
  std::set<std::pair<double, Ends>> longest_;  // of the edges that may be divided
};

}  // namespace

bool divideEdges(TriangleMesh& mesh, std::size_t vertices) {
  const auto names = [](const Attribute& attribute) {
    return attribute.semantic.starts_with("JOINTS");
  };
  if (std::any_of(mesh.attributes.begin(), mesh.attributes.end(), names)) return false;
  return Division(mesh).run(vertices);
}

}  // namespace remesher
