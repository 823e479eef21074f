// SPDX-License-Identifier: MIT
#include "remesh/schemes/follow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/place.h"
#include "geometry/mesh_tree.h"
#include "geometry/triangle.h"
#include "simplify/simplify.h"

namespace remesher {

namespace {

constexpr std::size_t kMostThinned = 32;

Index groupOf(const TriangleMesh& input, Index triangle) {
  return input.groups.empty() ? 0 : input.groups[triangle];
}

bool sameAttributes(const TriangleMesh& input, Index a, Index b) {
  return a == b ||
         std::all_of(input.attributes.begin(), input.attributes.end(), [&](const auto& x) {
           const auto at = [&](Index i) { return x.values.begin() + std::size_t{i} * x.itemSize; };
           return std::equal(at(a), at(a) + x.itemSize, at(b));
         });
}

// The edges across which an attribute jumps, or the group changes.
HalfedgeData<char> seamsOf(const BuiltMesh& built, const TriangleMesh& input) {
  const HalfedgeMesh& m = built.mesh;
  HalfedgeData<char> seams(m.halfedgeCapacity(), 0);
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i), t = m.isAlive(h) ? m.twin(h) : Halfedge();
    if (!t) continue;
    const auto group = [&](Halfedge e) { return groupOf(input, built.triangles[m.face(e)]); };
    const auto wedge = [&](Halfedge e) { return built.wedges[e]; };
    seams[h] = group(h) != group(t) || !sameAttributes(input, wedge(h), wedge(m.next(t))) ||
               !sameAttributes(input, wedge(m.next(h)), wedge(t));
  }
  return seams;
}

// The triangles of a simplified surface, each corner with that of the original that it stands for.
class Extraction {
 public:
  Extraction(const SimpleSurface& surface, const BuiltMesh& original, const TriangleMesh& input)
      : surface_(surface), original_(original), input_(input) {
    for (const Attribute& attribute : input.attributes)
      result_.mesh.attributes.push_back({attribute.semantic, attribute.itemSize, {}});
  }

  Followed run() {
    const HalfedgeMesh& m = surface_.mesh;
    for (Index f = 0; f < m.faceCapacity(); ++f) {
      if (!m.isAlive(Face(f))) continue;
      const auto [a, b, c] = m.vertices(Face(f));
      const auto& p = surface_.positions;
      const Vec3 normal = unitNormal(p[a], p[b], p[c]);
      const Index group = groupOf(input_, original_.triangles[Face(f)]);
      for (const Vertex v : {a, b, c}) addCorner(v, originalCorner(v, group, normal));
      if (!input_.groups.empty()) result_.mesh.groups.push_back(group);
    }
    return std::move(result_);
  }

 private:
  // Of the original's corners at v that whose triangle faces most alike, of the same group if there
  // is one.
  Halfedge originalCorner(Vertex v, Index group, const Vec3& normal) const {
    const auto& p = original_.positions;
    Halfedge best;
    double most = 0;
    original_.mesh.forEachOutgoing(v, [&](Halfedge h) {
      const auto [a, b, c] = original_.mesh.vertices(HalfedgeMesh::face(h));
      const bool isOwn = groupOf(input_, original_.triangles[HalfedgeMesh::face(h)]) == group;
      const double agreement = (isOwn ? 4 : 0) + unitNormal(p[a], p[b], p[c]).dot(normal);
      if (best && agreement <= most) return;
      best = h;
      most = agreement;
    });
    return best;
  }

  void addCorner(Vertex v, Halfedge original) {
    const Index wedge = original_.wedges[original];
    const auto [copy, isNew] =
        copies_.emplace(std::pair(v.index, wedge), Index(result_.mesh.positions.size()));
    result_.mesh.indices.push_back(copy->second);
    InputPlace place{original_.triangles[HalfedgeMesh::face(original)], Vec3::Zero()};
    for (Index k = 0; k < 3; ++k)
      if (input_.indices[3 * place.triangle + k] == wedge) place.weights[k] = 1;
    result_.places.push_back(place);
    if (!isNew) return;
    result_.mesh.positions.push_back(surface_.positions[v]);
    for (std::size_t a = 0; a < input_.attributes.size(); ++a) {
      const Attribute& from = input_.attributes[a];
      const auto first = from.values.begin() + std::ptrdiff_t(wedge) * from.itemSize;
      auto& to = result_.mesh.attributes[a].values;
      to.insert(to.end(), first, first + from.itemSize);
    }
  }

  const SimpleSurface& surface_;
  const BuiltMesh& original_;
  const TriangleMesh& input_;
  Followed result_;
  std::map<std::pair<Index, Index>, Index> copies_;
};

}  // namespace

std::size_t distinctPositions(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions) {
  std::vector<Vec3> places;
  places.reserve(mesh.vertexCount());
  for (Index i = 0; i < mesh.vertexCapacity(); ++i)
    if (mesh.isAlive(Vertex(i))) places.push_back(positions[Vertex(i)]);
  return countPlaces(places);
}

// Four points to a triangle, for its corners are where vertices may have stayed.
double distanceTo(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                  const BuiltMesh& original) {
  constexpr double kFar = 2.0 / 3, kNear = 1.0 / 6, kMiddle = 1.0 / 3;
  const std::array<Vec3, 4> weights = {Vec3(kMiddle, kMiddle, kMiddle), Vec3(kFar, kNear, kNear),
                                       Vec3(kNear, kFar, kNear), Vec3(kNear, kNear, kFar)};
  const MeshTree tree(mesh, positions);
  double sum = 0, total = 0;
  Face last;
  for (Index f = 0; f < original.mesh.faceCapacity(); ++f) {
    const auto [a, b, c] = original.mesh.vertices(Face(f));
    const auto& p = original.positions;
    const double share = area(p[a], p[b], p[c]) / double(weights.size());
    for (const Vec3& w : weights) {
      const MeshTree::Nearest nearest = tree.nearest(w[0] * p[a] + w[1] * p[b] + w[2] * p[c], last);
      last = nearest.face;
      sum += share * nearest.distance * nearest.distance;
      total += share;
    }
  }
  return total > 0 ? std::sqrt(sum / total) : 0;
}

std::optional<Followed> follow(const BuiltMesh& original, const TriangleMesh& input,
                               std::size_t positions) {
  if (original.mesh.vertexCount() > kMostThinned * positions) return {};
  SimpleSurface surface{original.mesh, original.positions, seamsOf(original, input)};
  std::size_t now = distinctPositions(surface.mesh, surface.positions);
  if (now <= positions) return {};
  // A collapse takes one place at most: where others share it, none.
  while (now > positions) {
    const std::size_t before = surface.mesh.vertexCount();
    simplify(surface, before - (now - positions));
    if (surface.mesh.vertexCount() == before) return {};
    now = distinctPositions(surface.mesh, surface.positions);
  }
  Followed result = Extraction(surface, original, input).run();
  result.distance = distanceTo(surface.mesh, surface.positions, original);
  return result;
}

}  // namespace remesher
