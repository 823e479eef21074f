// SPDX-License-Identifier: MIT
#include "repair/united.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "arrangement/arrangement.h"
#include "base/place.h"
#include "geometry/triangle_meeting.h"
#include "measure/mesh_report.h"
#include "mesh/attribute_mix.h"
#include "mesh/used_vertices.h"
#include "mesh/welding.h"
#include "repair/holes/turn_over.h"
#include "repair/stitch.h"

namespace remesher {

namespace {

// Steps of the arrangement: more than bodies of few crossings take, far less than soups would.
constexpr std::size_t kWorkBesides = 20'000'000, kWorkPerTriangle = 1000;

// The bodies with one vertex at each position, as the arrangement takes them.
struct Welded {
  ArrangementInput input;
  std::vector<Index> triangles;  // per triangle of the input that of the bodies
  std::vector<Index> vertices;   // per position of the input a vertex of the bodies there
};

Welded weldedOf(const TriangleMesh& bodies, const Operands& operands) {
  Welded welded;
  const std::vector<Index> first = weld(bodies.positions);
  std::vector<Index> numbers(first.size(), kNone);
  const auto numberOf = [&](Index vertex) {
    Index& number = numbers[first[vertex]];
    if (number == kNone) {
      number = Index(welded.input.positions.size());
      welded.input.positions.push_back(bodies.positions[first[vertex]]);
      welded.vertices.push_back(first[vertex]);
    }
    return number;
  };
  for (Index t = 0; t < bodies.triangleCount(); ++t) {
    const Index* v = &bodies.indices[3 * std::size_t{t}];
    const auto at = [&](int k) { return bodies.positions[first[v[k]]]; };
    if (!hasArea({at(0), at(1), at(2)})) continue;
    for (int k = 0; k < 3; ++k) welded.input.indices.push_back(numberOf(v[k]));
    welded.triangles.push_back(t);
    welded.input.operands.push_back(operands.numbers[t]);
  }
  welded.input.known = operands.known;
  if (const auto& meeting = operands.known.triangles)
    welded.input.known.triangles = numbersAmong(welded.triangles, *meeting);
  // Attributes are linear in one triangle only, so facets of different ones stay apart.
  if (!bodies.attributes.empty()) {
    welded.input.classes.resize(welded.triangles.size());
    std::iota(welded.input.classes.begin(), welded.input.classes.end(), Index{0});
  } else if (!bodies.groups.empty()) {
    for (const Index t : welded.triangles) welded.input.classes.push_back(bodies.groups[t]);
  }
  return welded;
}

// The arranged triangles as a mesh with the bodies' attributes.
class Assembly {
 public:
  Assembly(const TriangleMesh& bodies, const Welded& welded, const ArrangementResult& arranged)
      : bodies_(bodies),
        welded_(welded),
        arranged_(arranged),
        mix_(bodies),
        made_(arranged.positions.size(), kNone) {
    mesh_ = bodies;
    mesh_.indices.clear(), mesh_.groups.clear();
    mesh_.isQuads = false;
  }

  TriangleMesh run() {
    std::vector<Index> turned;
    for (Index i = 0; i < arranged_.triangles.size(); ++i) {
      const ArrangedTriangle& triangle = arranged_.triangles[i];
      const Index parent = welded_.triangles[triangle.parent];
      std::array<Index, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] =
            cornerAt(arranged_.indices[3 * std::size_t{i} + k], parent, triangle.weights[k]);
      // Turned back, so that turnOver() may turn normals with it.
      if (triangle.isTurned) std::swap(corners[1], corners[2]), turned.push_back(i);
      mesh_.indices.insert(mesh_.indices.end(), corners.begin(), corners.end());
      if (!bodies_.groups.empty()) mesh_.groups.push_back(bodies_.groups[parent]);
    }
    turnOver(mesh_, turned);
    keepUsedVertices(mesh_);
    return std::move(mesh_);
  }

 private:
  // The parent's own vertex at one of its corners; else a new one, which triangles share if their
  // attributes agree there.
  Index cornerAt(Index point, Index parent, const Vec3& weights) {
    const Index* v = &bodies_.indices[3 * std::size_t{parent}];
    for (std::size_t k = 0; k < 3; ++k)
      if (weights == Vec3::Unit(Eigen::Index(k)) && isAt(v[k], point)) return v[k];
    if (bodies_.attributes.empty() && point < welded_.vertices.size())
      return welded_.vertices[point];
    const auto at = [&](int k) { return bodies_.positions[v[k]]; };
    mesh_.positions.push_back(arranged_.positions[point]);
    if (!bodies_.attributes.empty())
      mix_.append({{v[0], v[1], v[2]}, weights, areaVector(at(0), at(1), at(2))}, mesh_.attributes);
    const Index made = Index(mesh_.positions.size() - 1);
    Index* last = &made_[point];
    while (*last != kNone) {
      if (haveSameAttributes(mesh_, *last, made)) {
        dropLastVertex(mesh_);
        return *last;
      }
      last = &next_[*last - bodies_.positions.size()];
    }
    *last = made;
    next_.push_back(kNone);
    return made;
  }

  // Corners that were brought together may have left their parent's.
  bool isAt(Index vertex, Index point) const {
    return bodies_.positions[vertex] == arranged_.positions[point];
  }

  const TriangleMesh& bodies_;
  const Welded& welded_;
  const ArrangementResult& arranged_;
  const AttributeMix mix_;
  TriangleMesh mesh_;
  std::vector<Index> made_;  // per point the first new vertex there
  std::vector<Index> next_;  // per new vertex the next at its point
};

}  // namespace

std::vector<Index> numbersAmong(std::span<const Index> list, std::span<const Index> wanted) {
  std::vector<Index> numbers;
  auto at = list.begin();
  for (const Index t : wanted) {
    at = std::lower_bound(at, list.end(), t);
    if (at == list.end()) break;
    if (*at == t) numbers.push_back(Index(at - list.begin()));
  }
  return numbers;
}

std::optional<United> arranged(const TriangleMesh& bodies, const Operands& operands) {
  const Welded welded = weldedOf(bodies, operands);
  ArrangementOptions options;
  options.isInside = operands.isInside;
  options.wantsWeights = !bodies.attributes.empty();
  options.isSingle = bodies.isSingle, options.frame = bodies.frame;
  options.mostWork = kWorkBesides + kWorkPerTriangle * bodies.triangleCount();
  const ArrangementResult found = arrange(welded.input, options);
  if (found.outcome != ArrangementResult::Outcome::Done) return std::nullopt;
  United result{Assembly(bodies, welded, found).run(),
                {},
                found.selfIntersections,
                0,
                found.cut,
                found.isOutsideDropped};
  for (const ArrangedTriangle& triangle : found.triangles)
    result.parents.push_back(welded.triangles[triangle.parent]);
  return result;
}

Defects defectsOf(const United& outside) {
  const Welding welding(outside.mesh);
  Defects defects{countUnbalancedEdges(welding), outside.crossings.size(),
                  touchingVertices(welding).size()};
  if (welding.twins.empty())
    welding.forEachEdge([&](std::span<const Index> edge) { defects.touches += edge.size() > 2; });
  return defects;
}

std::optional<United> united(const TriangleMesh& bodies, std::span<const Index> crossings,
                             Inside inside) {
  InsideRule isInside = isWound;
  if (inside == Inside::EitherWay)
    isInside = [](std::span<const int> windings) { return windings[0] != 0; };
  std::optional<United> result =
      arranged(bodies, {std::vector<Index>(bodies.triangleCount(), 0),
                        std::move(isInside),
                        {std::vector<Index>(crossings.begin(), crossings.end())}});
  if (result && result->mesh.indices.empty()) return std::nullopt;
  return result;
}

}  // namespace remesher
