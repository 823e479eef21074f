// SPDX-License-Identifier: MIT
#include "repair/holes/kept_surface.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "geometry/triangle.h"
#include "mesh/components.h"

namespace remesher {

namespace {

// The input's triangles that are kept so far.
class Selection {
 public:
  explicit Selection(const TriangleMesh& input)
      : input_(input), isKept_(input.triangleCount(), 1) {}

  // The kept triangles as a mesh of their own, with the manifold that is made of it.
  KeptSurface surface() const {
    KeptSurface kept;
    for (Index t = 0; t < isKept_.size(); ++t)
      if (isKept_[t]) kept.inputs.push_back(InputTriangle(t));
    if (kept.inputs.empty())
      throw Error(ErrorCode::NoTriangles, "Nothing is left when pinches and debris are removed.",
                  "Few of these triangles share edges: ask for another way of repair.");
    const bool isAll = kept.inputs.size() == isKept_.size();
    kept.mesh = isAll ? input_ : withTriangles(kept.inputs);
    kept.built = buildMesh(kept.mesh);
    return kept;
  }

  void remove(const KeptSurface& kept, const FaceData<char>& unwanted) {
    for (Index f = 0; f < unwanted.size(); ++f)
      if (unwanted[Face(f)]) isKept_[kept.inputs[kept.built.triangles[Face(f)]].index] = 0;
  }

 private:
  TriangleMesh withTriangles(const std::vector<InputTriangle>& triangles) const {
    TriangleMesh mesh = input_;
    mesh.indices.clear(), mesh.groups.clear();
    mesh.isQuads = false;
    for (const InputTriangle t : triangles) {
      const Index* v = &input_.indices[3 * std::size_t{t.index}];
      mesh.indices.insert(mesh.indices.end(), v, v + 3);
      if (!input_.groups.empty()) mesh.groups.push_back(input_.groups[t.index]);
    }
    return mesh;
  }

  const TriangleMesh& input_;
  std::vector<char> isKept_;  // per triangle
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

// The vertices with an open fan that coincide with another such vertex, sorted by position.
std::vector<std::pair<Index, Index>> pinchesOf(const BuiltMesh& built) {
  std::vector<std::pair<Index, Index>> open;  // the position, the vertex
  for (Index v = 0; v < built.sources.size(); ++v)
    if (built.mesh.isAlive(Vertex(v)) && built.mesh.isBoundary(Vertex(v)))
      open.emplace_back(built.sources[Vertex(v)], v);
  std::sort(open.begin(), open.end());
  std::vector<std::pair<Index, Index>> pinches;
  for (std::size_t i = 0; i < open.size(); ++i)
    if ((i > 0 && open[i - 1].first == open[i].first) ||
        (i + 1 < open.size() && open[i + 1].first == open[i].first))
      pinches.push_back(open[i]);
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

// Removing fans makes new pinches, seldom more than two or three times in a row. After kFanRounds
// whole stars are removed, after kStarRounds more whole components with a pinch. places: a pinch
// of each round is added.
KeptSurface withoutPinches(Selection& selection, std::vector<Vec3>& places) {
  constexpr int kFanRounds = 12, kStarRounds = 12;
  for (int round = 0;; ++round) {
    KeptSurface kept = selection.surface();
    const BuiltMesh& built = kept.built;
    const auto pinches = pinchesOf(built);
    if (pinches.empty()) return kept;
    places.push_back(built.positions[Vertex(pinches.front().second)]);
    if (round < kFanRounds + kStarRounds) {
      selection.remove(kept, facesAtPinches(built, pinches,
                                            round < kFanRounds ? Fans::AllButWidest : Fans::All));
      continue;
    }
    DisjointSets components = componentsOfVertices(built.mesh);
    std::vector<char> isPinched(built.mesh.vertexCapacity(), 0);
    for (const auto& [position, v] : pinches) isPinched[components.find(v)] = 1;
    FaceData<char> unwanted(built.mesh.faceCapacity(), 0);
    for (Index f = 0; f < unwanted.size(); ++f)
      unwanted[Face(f)] = isPinched[components.find(built.mesh.vertices(Face(f))[0].index)];
    selection.remove(kept, unwanted);
  }
}

// An open component with less than this share of the largest component's area is debris of a torn
// surface; closing it would make a flake.
constexpr double kDebrisShare = 0.01;
// Where all such components together have more than this share of the area they are what is shown,
// such as leaves.
constexpr double kMostDebris = 0.05;

struct FoundDebris {
  FaceData<char> faces;
  std::vector<Vec3> at;  // a corner of each component
};

FoundDebris debrisOf(const BuiltMesh& built) {
  DisjointSets components = componentsOfVertices(built.mesh);
  std::vector<double> areas(built.mesh.vertexCapacity(), 0);
  std::vector<char> isOpen(areas.size(), 0);
  for (Index f = 0; f < built.mesh.faceCapacity(); ++f) {
    const Index root = components.find(built.mesh.vertices(Face(f))[0].index);
    areas[root] += areaOf(built, Face(f));
    for (int k = 0; k < 3; ++k)
      if (built.mesh.isBoundary(HalfedgeMesh::halfedge(Face(f), k))) isOpen[root] = 1;
  }
  const double largest = *std::max_element(areas.begin(), areas.end());
  const auto isSmall = [&](Index root) {
    return isOpen[root] && areas[root] < kDebrisShare * largest;
  };
  double all = 0, small = 0;
  for (Index v = 0; v < areas.size(); ++v) {
    all += areas[v];
    if (isSmall(v)) small += areas[v];
  }
  const bool isShown = small > kMostDebris * all;
  const auto isDebris = [&](Index root) { return !isShown && isSmall(root); };
  FoundDebris debris{FaceData<char>(built.mesh.faceCapacity(), 0), {}};
  for (Index f = 0; f < built.mesh.faceCapacity(); ++f)
    debris.faces[Face(f)] = isDebris(components.find(built.mesh.vertices(Face(f))[0].index));
  for (Index v = 0; v < areas.size(); ++v)
    if (components.find(v) == v && built.mesh.isAlive(Vertex(v)) && isDebris(v))
      debris.at.push_back(built.positions[Vertex(v)]);
  return debris;
}

}  // namespace

KeptSurface keptSurface(const TriangleMesh& input, Debris debris) {
  Selection selection(input);
  std::vector<Vec3> pinches;
  KeptSurface kept = withoutPinches(selection, pinches);
  if (debris == Debris::Removed) {
    FoundDebris found = debrisOf(kept.built);
    if (!found.at.empty()) {
      selection.remove(kept, found.faces);
      kept = selection.surface();
    }
    kept.islands = found.at.size();
    kept.removedAt = std::move(found.at);
  }
  kept.removedAt.insert(kept.removedAt.end(), pinches.begin(), pinches.end());
  kept.trianglesRemoved = input.triangleCount() - kept.built.mesh.faceCount() - kept.built.lines;
  return kept;
}

}  // namespace remesher
