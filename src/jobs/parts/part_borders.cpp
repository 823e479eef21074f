// SPDX-License-Identifier: MIT
#include "jobs/parts/part_borders.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <string>

#include "base/disjoint_sets.h"
#include "base/place.h"
#include "mesh/joining.h"
#include "mesh/welding.h"

namespace remesher {
namespace {

// Joining distance per diagonal of the largest mesh: twice the rounding of its coordinates in
// single precision.
constexpr double kOfSingles = 0x1p-22;

struct BorderEdge {
  Index low, high;  // places
  bool isForward;   // from low to high
  Index mesh;
};

bool isBefore(const BorderEdge& a, const BorderEdge& b) {
  return std::pair(a.low, a.high) < std::pair(b.low, b.high);
}

// The borders of all meshes, their places numbered.
class Borders {
 public:
  explicit Borders(const std::vector<TriangleMesh>& meshes) : meshes_(meshes) {
    double largest = 0;
    for (const TriangleMesh& mesh : meshes) {
      largest = std::max(largest, diagonalOf(mesh));
      addBorder(mesh);
    }
    joinNear(points_, kOfSingles * largest);
    const std::vector<Index> first = weld(points_.positions);
    for (Index& place : places_)
      if (place != kNone) place = first[place];
    findEdges();
  }

  // Sets of two or more linked meshes, ascending, the meshes in each ascending.
  std::vector<std::vector<std::size_t>> linked() const {
    DisjointSets sets(meshes_.size());
    forEachEdge([&](auto begin, auto end) {
      if (isLink(begin, end)) sets.unite(begin->mesh, std::next(begin)->mesh);
    });
    std::map<Index, std::vector<std::size_t>> byFirst;
    for (Index i = 0; i < meshes_.size(); ++i) byFirst[sets.find(i)].push_back(i);
    std::vector<std::vector<std::size_t>> result;
    for (auto& [first, set] : byFirst)
      if (set.size() > 1) result.push_back(std::move(set));
    return result;
  }

  // Whether the meshes of a set together are a surface as sound as each of them.
  bool isSurface(const std::vector<std::size_t>& set) const {
    bool isSound = haveSameWidths(set) && haveOwnTriangles(set);
    forEachEdge([&](auto begin, auto end) {
      std::vector<BorderEdge> own;
      std::copy_if(begin, end, std::back_inserter(own), [&](const BorderEdge& edge) {
        return std::binary_search(set.begin(), set.end(), std::size_t{edge.mesh});
      });
      if (own.size() > 2 || (own.size() == 2 && own[0].isForward == own[1].isForward))
        isSound = false;
    });
    return isSound;
  }

  void bringTogether(TriangleMesh& mesh, std::size_t number) const {
    for (Index v = 0; v < mesh.positions.size(); ++v)
      if (const Index place = placeOf(number, v); place != kNone)
        mesh.positions[v] = points_.positions[place];
  }

 private:
  void addBorder(const TriangleMesh& mesh) {
    starts_.push_back(places_.size());
    places_.resize(places_.size() + mesh.positions.size(), kNone);
    if (mesh.indices.empty()) return;
    const Welding welding(mesh);
    const auto add = [&](Index v) {
      Index& place = places_[starts_.back() + v];
      if (place != kNone) return;
      place = Index(points_.positions.size());
      points_.indices.insert(points_.indices.end(), 3, place);
      points_.positions.push_back(mesh.positions[v]);
    };
    welding.forEachEdge([&](std::span<const Index> edge) {
      if (edge.size() != 1) return;
      add(welding.corners[edge[0]]);
      add(welding.corners[nextCorner(edge[0])]);
    });
    for (Index v = 0; v < mesh.positions.size(); ++v)
      places_[starts_.back() + v] = places_[starts_.back() + welding.first[v]];
  }

  void findEdges() {
    for (Index m = 0; m < meshes_.size(); ++m) {
      if (meshes_[m].indices.empty()) continue;
      const Welding welding(meshes_[m]);
      welding.forEachEdge([&](std::span<const Index> edge) {
        if (edge.size() != 1) return;
        const Index from = placeOf(m, welding.corners[edge[0]]);
        const Index to = placeOf(m, welding.corners[nextCorner(edge[0])]);
        edges_.push_back({std::min(from, to), std::max(from, to), from < to, m});
      });
    }
    std::stable_sort(edges_.begin(), edges_.end(), isBefore);
  }

  template <class Visit>
  void forEachEdge(Visit visit) const {
    for (auto begin = edges_.begin(); begin != edges_.end();) {
      const auto end = std::upper_bound(begin, edges_.end(), *begin, isBefore);
      visit(begin, end);
      begin = end;
    }
  }

  template <class Edge>
  static bool isLink(Edge begin, Edge end) {
    if (end - begin != 2) return false;
    const Edge other = std::next(begin);
    return begin->mesh != other->mesh && begin->isForward != other->isForward;
  }

  // Whether each attribute has the same width in all meshes of the set that have it.
  bool haveSameWidths(const std::vector<std::size_t>& set) const {
    std::map<std::string, int> widths;
    for (const std::size_t m : set)
      for (const Attribute& attribute : meshes_[m].attributes)
        if (widths.emplace(attribute.semantic, attribute.itemSize).first->second !=
            attribute.itemSize)
          return false;
    return true;
  }

  // Whether no triangle collapses and none lies on another: leaves with one mesh per side are not
  // united.
  bool haveOwnTriangles(const std::vector<std::size_t>& set) const {
    std::vector<std::array<Index, 3>> triangles;
    for (const std::size_t m : set) {
      const TriangleMesh& mesh = meshes_[m];
      for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::array<Index, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = placeOf(m, mesh.indices[i + k]);
        for (std::size_t k = 0; k < 3; ++k)
          if (corners[k] != kNone && corners[k] == corners[(k + 1) % 3] &&
              mesh.positions[mesh.indices[i + k]] != mesh.positions[mesh.indices[i + (k + 1) % 3]])
            return false;
        std::sort(corners.begin(), corners.end());
        if (corners[2] != kNone) triangles.push_back(corners);
      }
    }
    std::sort(triangles.begin(), triangles.end());
    return std::adjacent_find(triangles.begin(), triangles.end()) == triangles.end();
  }

  Index placeOf(std::size_t mesh, Index vertex) const { return places_[starts_[mesh] + vertex]; }

  const std::vector<TriangleMesh>& meshes_;
  TriangleMesh points_;              // on all borders, each a triangle by itself
  std::vector<std::size_t> starts_;  // per mesh, in places_
  std::vector<Index> places_;        // per vertex the first such point there; kNone inside
  std::vector<BorderEdge> edges_;    // sorted by places
};

}  // namespace

std::vector<std::vector<std::size_t>> joinedAlongBorders(std::vector<TriangleMesh>& meshes) {
  const Borders borders(meshes);
  std::vector<std::vector<std::size_t>> sets = borders.linked();
  std::erase_if(sets, [&](const auto& set) { return !borders.isSurface(set); });
  for (const std::vector<std::size_t>& set : sets)
    for (const std::size_t m : set) borders.bringTogether(meshes[m], m);
  return sets;
}

}  // namespace remesher
