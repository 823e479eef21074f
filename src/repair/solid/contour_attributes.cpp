// SPDX-License-Identifier: MIT
#include "repair/solid/contour_attributes.h"

#include <algorithm>
#include <utility>

#include "base/disjoint_sets.h"
#include "geometry/triangle.h"
#include "mesh/attribute_mix.h"

namespace remesher {

namespace {

// Triangles of one chart are connected by common vertices of the input, and so have one group: all
// attributes are continuous between them.
std::vector<Index> chartsOf(const TriangleMesh& input, const BuiltMesh& built) {
  DisjointSets sets(input.positions.size());
  for (std::size_t i = 0; i < input.indices.size(); i += 3) {
    sets.unite(input.indices[i], input.indices[i + 1]);
    sets.unite(input.indices[i + 1], input.indices[i + 2]);
  }
  std::vector<Index> charts;
  for (Index f = 0; f < built.mesh.faceCapacity(); ++f)
    charts.push_back(sets.find(built.wedges[HalfedgeMesh::halfedge(Face(f))]));
  return charts;
}

// Triangles over gaps have no source: the sources around a gap spread over it.
std::vector<Index> spreadSources(const Contour& contour) {
  std::vector<Index> sources = contour.triangleSources;
  std::vector<Index> ofPoints = contour.pointSources;
  for (bool isAny = true; isAny;) {
    isAny = false;
    for (std::size_t t = 0; t < sources.size(); ++t) {
      const Index* v = &contour.corners[3 * t];
      for (std::size_t k = 0; k < 3 && sources[t] == kNone; ++k) sources[t] = ofPoints[v[k]];
      if (sources[t] == kNone) continue;
      for (std::size_t k = 0; k < 3; ++k)
        if (ofPoints[v[k]] == kNone) ofPoints[v[k]] = sources[t], isAny = true;
    }
  }
  return sources;
}

class Carrier {
 public:
  Carrier(const Contour& contour, const TriangleMesh& input, const BuiltMesh& built)
      : contour_(contour),
        input_(input),
        built_(built),
        charts_(chartsOf(input, built)),
        sources_(spreadSources(contour)),
        mix_(input),
        first_(contour.points.size(), kNone) {
    mesh_.isSingle = input.isSingle, mesh_.frame = input.frame;
    for (const Attribute& attribute : input.attributes)
      mesh_.attributes.push_back({attribute.semantic, attribute.itemSize, {}});
  }

  TriangleMesh run() {
    for (std::size_t t = 0; t < sources_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k)
        mesh_.indices.push_back(vertexFor(contour_.corners[3 * t + k], sources_[t]));
      if (!input_.groups.empty())
        mesh_.groups.push_back(
            sources_[t] == kNone ? 0 : input_.groups[built_.triangles[Face(sources_[t])]]);
    }
    return std::move(mesh_);
  }

 private:
  // A point has one vertex for each chart that meets there; charts without attributes do not
  // differ.
  Index vertexFor(Index point, Index source) {
    const bool isAlike = input_.attributes.empty() || source == kNone;
    const Index chart = isAlike ? kNone : charts_[source];
    Index* vertex = &first_[point];
    while (*vertex != kNone && vertices_[*vertex].chart != chart) vertex = &vertices_[*vertex].next;
    if (*vertex != kNone) return *vertex;
    const Index number = *vertex = Index(vertices_.size());
    vertices_.push_back({chart});
    const Index own = contour_.pointSources[point];
    mesh_.positions.push_back(contour_.points[point]);
    append(contour_.points[point], own != kNone && charts_[own] == chart ? own : source);
    return number;
  }

  void append(const Vec3& p, Index face) {
    if (input_.attributes.empty()) return;
    std::array<Index, 3> wedges{};
    Vec3 weights(1, 0, 0), normal = Vec3::Zero();
    if (face != kNone) {
      const auto [a, b, c] = built_.mesh.vertices(Face(face));
      weights =
          closestBarycentric(p, built_.positions[a], built_.positions[b], built_.positions[c]);
      normal = areaVector(built_.positions[a], built_.positions[b], built_.positions[c]);
      for (int k = 0; k < 3; ++k)
        wedges[std::size_t(k)] = built_.wedges[HalfedgeMesh::halfedge(Face(face), k)];
    }
    mix_.append({wedges, weights, normal}, mesh_.attributes);
  }

  const Contour& contour_;
  const TriangleMesh& input_;
  const BuiltMesh& built_;
  std::vector<Index> charts_;   // per face
  std::vector<Index> sources_;  // per triangle of the contour
  const AttributeMix mix_;
  struct Known {
    Index chart, next = kNone;  // next: another vertex at the same point
  };
  std::vector<Index> first_;  // per point
  std::vector<Known> vertices_;
  TriangleMesh mesh_;
};

}  // namespace

std::vector<Index> kindsOf(const Contour& contour, const TriangleMesh& input,
                           const BuiltMesh& built) {
  const std::vector<Index> sources = spreadSources(contour);
  if (input.attributes.empty() && input.groups.empty())
    return std::vector<Index>(sources.size(), 0);
  const bool areOnlyNormals =
      std::all_of(input.attributes.begin(), input.attributes.end(),
                  [](const Attribute& attribute) { return attribute.semantic == "NORMAL"; });
  if (!areOnlyNormals) return sources;
  const std::vector<Index> charts = chartsOf(input, built);
  std::vector<Index> kinds;
  for (const Index source : sources) kinds.push_back(source == kNone ? kNone : charts[source]);
  return kinds;
}

TriangleMesh withAttributes(const Contour& contour, const TriangleMesh& input,
                            const BuiltMesh& built) {
  return Carrier(contour, input, built).run();
}

}  // namespace remesher
