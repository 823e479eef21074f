// SPDX-License-Identifier: MIT
#include "remesh/symmetry/joined.h"

#include <algorithm>
#include <utility>

#include "remesh/quads/mesh/quad_check.h"
#include "remesh/symmetry/mirroring.h"

namespace remesher {

namespace {

class Joining {
 public:
  Joining(const PlacedQuads& made, const Half& half, const Mirrors& mirrors,
          const InputAttributes& whole)
      : made_(made),
        half_(half),
        mirrors_(mirrors),
        whole_(whole),
        images_(mirroredQuads(made.mesh, mirrors)),
        placeOf_(placeNumbers(images_)) {
    mesh_.isQuads = true;
    for (const Attribute& attribute : made.mesh.attributes)
      mesh_.attributes.push_back({attribute.semantic, attribute.itemSize, {}});
  }

  bool isSound(Kind kind) const {
    QuadMesh mesh;
    mesh.vertices.resize(1 + *std::max_element(placeOf_.begin(), placeOf_.end()));
    for (const MirroredQuad& quad : images_.quads) {
      Four<Index> corners{};
      for (std::size_t k = 0; k < 4; ++k) corners[k] = placeOf_[quad.vertices[k]];
      mesh.quads.push_back(corners);
      mesh.curves.push_back({kNone, kNone, kNone, kNone});
    }
    if (!check(mesh).empty()) return false;
    return kind == Kind::Any || kindOf(mesh) == kindOf(whole_.surface().mesh());
  }

  PlacedQuads run() {
    for (const MirroredQuad& quad : images_.quads)
      for (const Index corner : quad.corners) places_.push_back(placeOf(corner, quad.image));
    addVertices();
    addTriangles();
    return {std::move(mesh_), std::move(trianglePlaces_)};
  }

 private:
  // An image's place is on the triangle that a point a little inside of the half's own triangle
  // comes to, so that it is on the same side of seams.
  InputPlace placeOf(Index corner, Image image) const {
    const InputPlace& own = made_.places[corner];
    const std::array<InputPlace, 3>& corners = half_.places[own.triangle.index];
    InputPlace place{corners[0].triangle, Vec3::Zero()};
    Vec3 middle = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      place.weights += own.weights[Eigen::Index(k)] * corners[k].weights;
      middle += corners[k].weights / 3;
    }
    if (image == 0) return place;
    constexpr double kInside = 1e-3;  // of the way to the middle
    const Vec3 inside = place.weights + kInside * (middle - place.weights);
    const Face face = whole_.faceNear(mirrored(whole_.position(place.triangle, inside), image));
    return whole_.placeIn(face, mirrored(whole_.position(place.triangle, place.weights), image));
  }

  Vec3 mirrored(Vec3 p, Image image) const {
    for (std::size_t i = 0; i < mirrors_.planes.size(); ++i)
      if ((image >> i & 1U) != 0) p = mirrors_.planes[i].mirrored(p);
    return p;
  }

  // Vertices at one place with the same attributes become one.
  void addVertices() {
    vertexOf_.assign(images_.vertices.size(), kNone);
    std::vector<std::vector<Index>> known(images_.vertices.size());  // by places
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Index v = images_.quads[i / 4].vertices[i % 4];
      if (vertexOf_[v] != kNone) continue;
      const Index added = add(images_.vertices[v], places_[i]);
      std::vector<Index>& others = known[placeOf_[v]];
      const auto same = std::find_if(others.begin(), others.end(),
                                     [&](Index w) { return haveSameAttributes(mesh_, w, added); });
      vertexOf_[v] = same == others.end() ? added : *same;
      same == others.end() ? others.push_back(added) : dropLastVertex(mesh_);
    }
  }

  Index add(const MirroredVertex& vertex, const InputPlace& place) {
    mesh_.positions.push_back(vertex.position);
    if (vertex.image != 0)
      whole_.append(place, mesh_.attributes);
    else
      for (std::size_t a = 0; a < mesh_.attributes.size(); ++a)
        appendValue(mesh_.attributes[a], made_.mesh.attributes[a], vertex.source);
    return Index(mesh_.positions.size() - 1);
  }

  // No two quads in a row begin at the same corner, as FB_ngon_encoding wants.
  void addTriangles() {
    Index last = kNone;
    for (std::size_t q = 0; q < images_.quads.size(); ++q) {
      const std::array<Index, 4>& quad = images_.quads[q].vertices;
      const std::size_t first = vertexOf_[quad[0]] == last ? 2 : 0;
      last = vertexOf_[quad[first]];
      for (const std::size_t k : {0, 1, 2, 0, 2, 3}) {
        const std::size_t corner = (first + k) % 4;
        mesh_.indices.push_back(vertexOf_[quad[corner]]);
        trianglePlaces_.push_back(places_[4 * q + corner]);
      }
      if (whole_.input().groups.empty()) continue;
      mesh_.groups.insert(mesh_.groups.end(), 2,
                          whole_.input().groups[places_[4 * q].triangle.index]);
    }
  }

  const PlacedQuads& made_;
  const Half& half_;
  const Mirrors& mirrors_;
  const InputAttributes& whole_;
  const MirroredQuads images_;
  const std::vector<Index> placeOf_;  // per vertex of the images
  std::vector<InputPlace> places_;    // per corner of the images' quads
  std::vector<Index> vertexOf_;       // of the result, per vertex of the images
  TriangleMesh mesh_;
  std::vector<InputPlace> trianglePlaces_;
};

}  // namespace

std::optional<PlacedQuads> joinedImages(const PlacedQuads& made, const Half& half,
                                        const JoinGoal& goal, const InputAttributes& whole) {
  Joining joining(made, half, goal.mirrors, whole);
  if (!joining.isSound(goal.kind)) return {};
  return joining.run();
}

}  // namespace remesher
