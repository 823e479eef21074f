// SPDX-License-Identifier: MIT
#include "remesh/schemes/follow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "base/place.h"
#include "geometry/distance_sampler.h"
#include "geometry/mesh_tree.h"
#include "geometry/mesh_triangle.h"
#include "geometry/triangle.h"
#include "mesh/joints.h"
#include "remesh/schemes/attribute_lengths.h"
#include "remesh/transfer/attribute_transfer.h"
#include "remesh/transfer/moved_corners.h"
#include "simplify/simplify.h"

namespace remesher {

namespace {

Index groupOf(const TriangleMesh& input, Index triangle) {
  return input.groups.empty() ? 0 : input.groups[triangle];
}

// The triangles of a simplified surface, each corner with the corner of the original that it stands
// for.
class Extraction {
 public:
  // kept: the attributes that the corners keep, or null. areBaked: corners whose vertex has moved
  // take their attributes from where it is now.
  Extraction(const SimpleSurface& surface, const BuiltMesh& original, const TriangleMesh& input,
             const KeptAttributes* kept, bool areBaked)
      : surface_(surface), original_(original), input_(input), kept_(kept) {
    if (kept) corners_.resize(input.positions.size());
    for (Index i = 0; kept && i < original.mesh.halfedgeCapacity(); ++i)
      if (original.mesh.isAlive(Halfedge(i))) corners_[original.wedges[Halfedge(i)]] = Halfedge(i);
    for (const Attribute& attribute : input.attributes)
      result_.mesh.attributes.push_back({attribute.semantic, attribute.itemSize, {}});
    if (areBaked && !input.attributes.empty())
      moved_.emplace(original, input, seamsOf(original, input, Textures::Bake));
  }

  Followed run() {
    const HalfedgeMesh& m = surface_.mesh;
    for (Index f = 0; f < m.faceCapacity(); ++f) {
      if (!m.isAlive(Face(f))) continue;
      const auto [a, b, c] = m.vertices(Face(f));
      const auto& p = surface_.positions;
      const Vec3 normal = unitNormal(p[a], p[b], p[c]);
      const Index group = groupOf(input_, original_.triangles[Face(f)]);
      for (int k = 0; k < 3; ++k) {
        const Halfedge corner = HalfedgeMesh::halfedge(Face(f), k);
        addCorner(m.origin(corner), originalCorner(corner, group, normal));
      }
      if (!input_.groups.empty()) result_.mesh.groups.push_back(group);
    }
    return std::move(result_);
  }

 private:
  // Of the original's corners at the same vertex, the one whose triangle faces most alike; corners
  // of the same look and group come first.
  Halfedge originalCorner(Halfedge corner, Index group, const Vec3& normal) const {
    const auto& p = original_.positions;
    Halfedge best;
    double most = 0;
    original_.mesh.forEachOutgoing(surface_.mesh.origin(corner), [&](Halfedge h) {
      const auto [a, b, c] = original_.mesh.vertices(HalfedgeMesh::face(h));
      const bool isOwn = groupOf(input_, original_.triangles[HalfedgeMesh::face(h)]) == group;
      const bool isSame = kept_ && haveSameLook(input_, original_.wedges[h], kept_->wedges[corner]);
      const double agreement =
          (isSame ? 8 : 0) + (isOwn ? 4 : 0) + unitNormal(p[a], p[b], p[c]).dot(normal);
      if (best && agreement <= most) return;
      best = h;
      most = agreement;
    });
    // Attributes may have come here from another vertex, where seams meet.
    const bool isMoved =
        kept_ && !haveSameLook(input_, original_.wedges[best], kept_->wedges[corner]);
    return isMoved ? corners_[kept_->wedges[corner]] : best;
  }

  // Groups may share a copy, but not the place on the input.
  void addMoved(Halfedge original, const Vec3& p, Index copy, bool isNew) {
    const Index group = groupOf(input_, original_.triangles[HalfedgeMesh::face(original)]);
    const auto [place, isFirst] = placesOfMoved_.emplace(std::pair(copy, group), SurfacePoint{});
    if (isFirst) place->second = moved_->pointNear(original, p);
    if (isNew) moved_->append(place->second, result_.mesh.attributes);
    result_.places.push_back(inputPlace(place->second, original_, input_));
  }

  void addCorner(Vertex v, Halfedge original) {
    const Index wedge = original_.wedges[original];
    const auto [copy, isNew] =
        copies_.emplace(std::pair(v.index, wedge), Index(result_.mesh.positions.size()));
    result_.mesh.indices.push_back(copy->second);
    const Vec3& p = surface_.positions[v];
    if (isNew) result_.mesh.positions.push_back(p);
    if (moved_ && p != original_.positions[v]) return addMoved(original, p, copy->second, isNew);
    InputPlace place{InputTriangle(original_.triangles[HalfedgeMesh::face(original)]),
                     Vec3::Zero()};
    for (Index k = 0; k < 3; ++k)
      if (input_.indices[cornerOf(place.triangle, k)] == wedge) place.weights[k] = 1;
    result_.places.push_back(place);
    if (!isNew) return;
    for (std::size_t a = 0; a < input_.attributes.size(); ++a)
      appendValue(result_.mesh.attributes[a], input_.attributes[a], wedge);
  }

  const SimpleSurface& surface_;
  const BuiltMesh& original_;
  const TriangleMesh& input_;
  const KeptAttributes* kept_;
  std::vector<Halfedge> corners_;      // one of each wedge
  std::optional<MovedCorners> moved_;  // where vertices move and textures are baked
  std::map<std::pair<Index, Index>, SurfacePoint> placesOfMoved_;  // by copy and group
  Followed result_;
  std::map<std::pair<Index, Index>, Index> copies_;
};

// Whether each vertex is at a joint.
VertexData<char> atJoints(const BuiltMesh& built) {
  VertexData<char> isAtJoint(built.mesh.vertexCapacity(), 0);
  for (const Halfedge h : findJoints(built))
    isAtJoint[built.mesh.origin(h)] = isAtJoint[built.mesh.tip(h)] = 1;
  return isAtJoint;
}

// The original as the simplifier takes it, with the attributes that its vertices keep; baked
// textures need none.
struct Beginning {
  Beginning(const BuiltMesh& original, const TriangleMesh& input, Textures textures,
            std::span<const Index> bodies = {})
      : surface{original.mesh, original.positions, seamsOf(original, input, textures)},
        attributes(attributesAsLengths(original, input)),
        keepsLook(textures != Textures::Bake) {
    if (original.keepsJoints) surface.held = atJoints(original);
    if (bodies.empty()) return;
    surface.bodies.resize(original.mesh.faceCapacity(), kNone);
    for (Index f = 0; f < original.mesh.faceCapacity(); ++f)
      if (original.mesh.isAlive(Face(f)))
        surface.bodies[Face(f)] = bodies[groupOf(input, original.triangles[Face(f)])];
  }

  std::size_t positions() const {
    return distinctPositions(surface.mesh, surface.positions, surface.bodies);
  }

  KeptAttributes* kept() { return keepsLook && attributes.itemSize > 0 ? &attributes : nullptr; }

  SimpleSurface surface;
  KeptAttributes attributes;
  bool keepsLook;
};

}  // namespace

HalfedgeData<char> seamsOf(const BuiltMesh& built, const TriangleMesh& input, Textures textures) {
  const HalfedgeMesh& m = built.mesh;
  const bool keepsLook = textures != Textures::Bake;
  HalfedgeData<char> seams(m.halfedgeCapacity(), 0);
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i), t = m.isAlive(h) ? m.twin(h) : Halfedge();
    if (!t) continue;
    const auto group = [&](Halfedge e) { return groupOf(input, built.triangles[m.face(e)]); };
    const auto areSame = [&](const auto& compare) {
      return compare(built.wedges[h], built.wedges[m.next(t)]) &&
             compare(built.wedges[m.next(h)], built.wedges[t]);
    };
    const bool isSame = areSame([&](Index a, Index b) {
      return keepsLook ? haveSameLook(input, a, b) : haveSameAttributes(input, a, b);
    });
    const bool isOneChart = areSame([&](Index a, Index b) {
      return haveSameAttributes(
          input, a, b, [](std::string_view semantic) { return semantic.starts_with("TEXCOORD"); });
    });
    seams[h] = group(h) != group(t) || !isOneChart ? kSeam : isSame ? kNoSeam : kJump;
  }
  return seams;
}

std::size_t distinctPositions(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions) {
  std::vector<Vec3> places;
  places.reserve(mesh.vertexCount());
  for (Index i = 0; i < mesh.vertexCapacity(); ++i)
    if (mesh.isAlive(Vertex(i))) places.push_back(positions[Vertex(i)]);
  return countPlaces(places);
}

std::size_t distinctPositions(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                              const FaceData<Index>& bodies) {
  if (bodies.size() == 0) return distinctPositions(mesh, positions);
  std::vector<std::pair<Index, Index>> visits;  // pairs of body and vertex
  for (Index f = 0; f < mesh.faceCapacity(); ++f)
    if (mesh.isAlive(Face(f)))
      for (const Vertex v : mesh.vertices(Face(f))) visits.emplace_back(bodies[Face(f)], v.index);
  std::sort(visits.begin(), visits.end());
  visits.erase(std::unique(visits.begin(), visits.end()), visits.end());
  std::size_t count = 0;
  std::vector<Vec3> places;
  for (auto visit = visits.begin(); visit != visits.end();) {
    const Index body = visit->first;
    places.clear();
    for (; visit != visits.end() && visit->first == body; ++visit)
      places.push_back(positions[Vertex(visit->second)]);
    count += countPlaces(places);
  }
  return count;
}

bool hasDegenerate(const TriangleMesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto [a, b, c] = cornersOf(mesh, t);
    if (flatness(a, b, c) <= kFlattest) return true;
  }
  return false;
}

// Samples lie away from a triangle's corners, for vertices may have stayed there. Boundaries are
// sampled, too: where a flat surface lost part of its outline, nothing else is away.
Away awayFrom(const MeshTree& other, const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
              const Samples& samples) {
  constexpr double kFar = 2.0 / 3, kNear = 1.0 / 6;
  const std::array<Vec3, 4> weights = {Vec3::Constant(1.0 / 3), Vec3(kFar, kNear, kNear),
                                       Vec3(kNear, kFar, kNear), Vec3(kNear, kNear, kFar)};
  const Index step = Index(1 + mesh.faceCapacity() / samples.triangles);
  DistanceSampler sampler(other.triangles());
  for (Index f = 0; f < mesh.faceCapacity(); f += step) {
    if (!mesh.isAlive(Face(f))) continue;
    const auto [a, b, c] = mesh.vertices(Face(f));
    const auto& p = positions;
    const double share = area(p[a], p[b], p[c]) / double(samples.ofEach);
    for (const Vec3& w : std::span(weights).first(samples.ofEach))
      sampler.add(w[0] * p[a] + w[1] * p[b] + w[2] * p[c], share);
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = HalfedgeMesh::halfedge(Face(f), k);
      if (!mesh.isBoundary(h)) continue;
      const Vec3 &begin = p[mesh.origin(h)], &end = p[mesh.origin(HalfedgeMesh::next(h))];
      for (const double t : {0.0, 0.25, 0.5, 0.75})
        sampler.addBeyond(sampler.farthest(), begin + t * (end - begin));
    }
  }
  return {sampler.rms(), sampler.farthest()};
}

bool isWorthFollowing(const BuiltMesh& original, std::size_t positions) {
  constexpr std::size_t kMostThinned = 32;
  return original.mesh.vertexCount() <= kMostThinned * positions;
}

std::vector<double> followCosts(const BuiltMesh& original, const TriangleMesh& input,
                                Textures textures) {
  Beginning begin(original, input, textures);
  const std::vector<double> costs = collapseCosts(begin.surface, begin.kept());
  const std::size_t before = distinctPositions(original.mesh, original.positions),
                    left = distinctPositions(begin.surface.mesh, begin.surface.positions);
  std::vector<double> ofPositions;
  for (std::size_t i = 0; i + left < before; ++i)
    ofPositions.push_back(costs[i * costs.size() / (before - left)]);
  return ofPositions;
}

std::optional<Followed> follow(const BuiltMesh& original, const TriangleMesh& input,
                               std::size_t positions, const FollowRule& rule) {
  Beginning begin(original, input, rule.textures, rule.bodies);
  std::size_t now = begin.positions();
  if (now < positions) return {};
  if (now == positions && !begin.keepsLook && !rule.mayBeOriginal) return {};
  SimpleSurface& surface = begin.surface;
  KeptAttributes* const kept = begin.kept();
  // A collapse takes one position at most, and none if other vertices share it.
  do {
    const std::size_t before = countVertices(surface);
    simplify(surface, before - (now - positions), kept);
    const bool isStuck = now > positions && countVertices(surface) == before;
    if (isStuck && rule.tooFew != TooFew::Raise) return {};
    now = begin.positions();
    if (isStuck) break;
  } while (now > positions);
  Followed result = Extraction(surface, original, input, kept, !begin.keepsLook).run();
  result.positions = now;
  result.away = awayFrom({surface.mesh, surface.positions}, original.mesh, original.positions);
  return result;
}

}  // namespace remesher
