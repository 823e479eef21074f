// SPDX-License-Identifier: MIT
#include "repair/holes/kept_surface.h"

#include <algorithm>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/error.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

// The input triangles that are kept so far.
struct Stay {
  const TriangleMesh& input;
  std::vector<Index> triangles;

  explicit Stay(const TriangleMesh& mesh) : input(mesh), triangles(mesh.triangleCount()) {
    for (Index t = 0; t < triangles.size(); ++t) triangles[t] = t;
  }

  BuiltMesh build() const {
    TriangleMesh part;
    part.positions = input.positions;
    for (const Index t : triangles)
      for (std::size_t k = 0; k < 3; ++k)
        part.indices.push_back(input.indices[3 * std::size_t{t} + k]);
    if (part.indices.empty())
      throw Error(ErrorCode::NoTriangles, "Nothing is left when pinches and islands are taken off.",
                  "These triangles hardly hang together: ask for another way of repair.");
    BuiltMesh built = buildMesh(part);
    for (Index& t : built.triangles.values()) t = triangles[t];
    return built;
  }

  // Returns the number of triangles removed.
  std::size_t remove(const BuiltMesh& built, const FaceData<char>& unwanted) {
    std::vector<char> goes(input.triangleCount(), 0);
    for (Index f = 0; f < unwanted.size(); ++f)
      if (unwanted[Face(f)]) goes[built.triangles[Face(f)]] = 1;
    return std::erase_if(triangles, [&](Index t) { return goes[t]; });
  }
};

double areaOf(const BuiltMesh& built, Face f) {
  const auto [a, b, c] = built.mesh.vertices(f);
  return area(built.positions[a], built.positions[b], built.positions[c]);
}

double fanArea(const BuiltMesh& built, Vertex v) {
  double sum = 0;
  built.mesh.forEachOutgoing(v, [&](Halfedge h) { sum += areaOf(built, HalfedgeMesh::face(h)); });
  return sum;
}

// The vertices that coincide with another vertex, sorted by place.
std::vector<std::pair<Index, Index>> pinchesOf(const BuiltMesh& built) {
  std::vector<std::pair<Index, Index>> all;  // the place, the vertex
  for (Index v = 0; v < built.sources.size(); ++v) all.emplace_back(built.sources[Vertex(v)], v);
  std::sort(all.begin(), all.end());
  std::vector<std::pair<Index, Index>> pinches;
  for (std::size_t i = 0; i < all.size(); ++i)
    if ((i > 0 && all[i - 1].first == all[i].first) ||
        (i + 1 < all.size() && all[i + 1].first == all[i].first))
      pinches.push_back(all[i]);
  return pinches;
}

enum class Fans { AllButWidest, All };

FaceData<char> facesAtPinches(const BuiltMesh& built,
                              const std::vector<std::pair<Index, Index>>& pinches, Fans fans) {
  FaceData<char> unwanted(built.mesh.faceCapacity(), 0);
  for (std::size_t i = 0, end = 0; i < pinches.size(); i = end) {
    std::size_t widest = i;
    double most = -1;
    for (end = i; end < pinches.size() && pinches[end].first == pinches[i].first; ++end)
      if (const double own = fanArea(built, Vertex(pinches[end].second)); own > most)
        widest = end, most = own;
    for (std::size_t k = i; k < end; ++k) {
      if (fans == Fans::AllButWidest && k == widest) continue;
      built.mesh.forEachOutgoing(Vertex(pinches[k].second),
                                 [&](Halfedge h) { unwanted[HalfedgeMesh::face(h)] = 1; });
    }
  }
  return unwanted;
}

DisjointSets componentsOf(const BuiltMesh& built) {
  DisjointSets components(built.mesh.vertexCapacity());
  for (Index f = 0; f < built.mesh.faceCapacity(); ++f) {
    const auto [a, b, c] = built.mesh.vertices(Face(f));
    components.unite(a.index, b.index);
    components.unite(b.index, c.index);
  }
  return components;
}

// Removing fans makes new pinches, seldom more than two or three times in a row. After kFanRounds
// whole stars are removed, after kStarRounds more whole components with a pinch.
BuiltMesh withoutPinches(Stay& stay) {
  constexpr int kFanRounds = 12, kStarRounds = 12;
  for (int round = 0;; ++round) {
    BuiltMesh built = stay.build();
    const auto pinches = pinchesOf(built);
    if (pinches.empty()) return built;
    if (round < kFanRounds + kStarRounds) {
      stay.remove(built, facesAtPinches(built, pinches,
                                        round < kFanRounds ? Fans::AllButWidest : Fans::All));
      continue;
    }
    DisjointSets components = componentsOf(built);
    std::vector<char> isPinched(built.mesh.vertexCapacity(), 0);
    for (const auto& [place, v] : pinches) isPinched[components.find(v)] = 1;
    FaceData<char> unwanted(built.mesh.faceCapacity(), 0);
    for (Index f = 0; f < unwanted.size(); ++f)
      unwanted[Face(f)] = isPinched[components.find(built.mesh.vertices(Face(f))[0].index)];
    stay.remove(built, unwanted);
  }
}

// An open component with less than this share of the largest component's area is a scrap of torn
// surface; closing it would make a flake. Scraps of the torn bunny are below 1/5000; separate
// bodies of models are seldom below 1/100.
constexpr double kIslandShare = 0.01;

// The faces of islands, and the number of islands.
std::pair<FaceData<char>, std::size_t> islandsOf(const BuiltMesh& built) {
  DisjointSets components = componentsOf(built);
  std::vector<double> areas(built.mesh.vertexCapacity(), 0);
  std::vector<char> isOpen(areas.size(), 0);
  for (Index f = 0; f < built.mesh.faceCapacity(); ++f) {
    const Index root = components.find(built.mesh.vertices(Face(f))[0].index);
    areas[root] += areaOf(built, Face(f));
    for (int k = 0; k < 3; ++k)
      if (built.mesh.isBoundary(HalfedgeMesh::halfedge(Face(f), k))) isOpen[root] = 1;
  }
  const double largest = *std::max_element(areas.begin(), areas.end());
  const auto isIsland = [&](Index root) {
    return isOpen[root] && areas[root] < kIslandShare * largest;
  };
  std::pair<FaceData<char>, std::size_t> result{{built.mesh.faceCapacity(), 0}, 0};
  for (Index f = 0; f < built.mesh.faceCapacity(); ++f)
    result.first[Face(f)] = isIsland(components.find(built.mesh.vertices(Face(f))[0].index));
  for (Index v = 0; v < areas.size(); ++v)
    result.second += components.find(v) == v && built.mesh.isAlive(Vertex(v)) && isIsland(v);
  return result;
}

}  // namespace

KeptSurface keptSurface(const TriangleMesh& input) {
  Stay stay(input);
  BuiltMesh built = withoutPinches(stay);
  const auto [unwanted, islands] = islandsOf(built);
  if (islands > 0) {
    stay.remove(built, unwanted);
    built = stay.build();
  }
  const std::size_t removed = input.triangleCount() - built.mesh.faceCount();
  return {std::move(built), islands, removed};
}

}  // namespace remesher
