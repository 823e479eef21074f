// SPDX-License-Identifier: MIT
#include "remesh/accuracy/places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/fires.h"
#include "geometry/extremes.h"
#include "geometry/mesh_tree.h"
#include "geometry/triangle.h"
#include "mesh/hubs.h"
#include "original/surface/surface_walk.h"

namespace remesher {

namespace {

// Of the target edge length.
constexpr double kSpacing = 0.5;
// Per vertex of the mesh and triangle of the original.
constexpr double kMostPlaces = 64;

struct Start {
  Face face;
  double enough = 0;  // a walk may end this near
};

// Walks from `start` to the place. If the walk ends nearer than before, updates the place and
// returns true.
bool improve(const WorkingMesh& mesh, Place& place, const Start& start) {
  const SurfacePoint near =
      closestPointFrom(mesh.mesh(), mesh.positions(), start.face, {place.position, start.enough});
  const auto [a, b, c] = mesh.mesh().vertices(near.face);
  const Vec3& w = near.barycentric;
  const Vec3 there = w[0] * mesh.position(a) + w[1] * mesh.position(b) + w[2] * mesh.position(c);
  const double distance = (there - place.position).norm();
  if (distance >= place.distance) return false;
  place.nearest = near.face;
  place.distance = distance;
  return true;
}

// The vertices of the original to measure from: all of them, or those that a proxy kept. The
// vertices that it left out lay beside these.
class Anchors {
 public:
  explicit Anchors(const Run& run)
      : original_(run.mesh.surface().mesh()), thinned_(run.grounds.thinned) {}

  // The neighbourhood of anchors: a mesh whose vertices are the anchors, by numbers of their own.
  const HalfedgeMesh& mesh() const { return thinned_ ? *thinned_->mesh : original_; }
  Vertex near(Vertex original) const {
    return thinned_ ? (*thinned_->collapseMap)[original] : original;
  }
  Vertex original(Vertex anchor) const {
    return thinned_ ? (*thinned_->onOriginal)[anchor] : anchor;
  }

 private:
  const HalfedgeMesh& original_;
  const std::optional<Thinned> thinned_;
};

// For each anchor a vertex of the mesh that lies near it along the surface: one on the anchor's own
// faces or, failing that, the one of a neighbouring anchor. Anchors that only a hub reaches come
// last.
class NearbyVertices {
 public:
  NearbyVertices(const WorkingMesh& mesh, const Anchors& anchors)
      : anchors_(anchors), near_(anchors.mesh().vertexCapacity()) {
    seed(mesh);
    spread();
  }

  Vertex operator[](Vertex anchor) const { return near_[anchor]; }

 private:
  void seed(const WorkingMesh& mesh) {
    const VertexData<Vec3>& positions = mesh.surface().positions();
    for (Index i = 0; i < mesh.mesh().vertexCapacity(); ++i) {
      const Vertex w(i);
      if (!mesh.mesh().isAlive(w)) continue;
      for (const Vertex v : mesh.surface().mesh().vertices(mesh.at(w).face)) {
        const Vertex anchor = anchors_.near(v);
        const Vec3& at = positions[anchors_.original(anchor)];
        if (!near_[anchor]) reached_.push_back(anchor);
        const auto distance2 = [&](Vertex u) { return (mesh.position(u) - at).squaredNorm(); };
        if (!near_[anchor] || distance2(w) < distance2(near_[anchor])) near_[anchor] = w;
      }
    }
  }

  void spreadFrom(Vertex from) {
    anchors_.mesh().forEachNeighbor(from, [&](Vertex v) {
      if (near_[v]) return;
      near_[v] = near_[from];
      reached_.push_back(v);
    });
  }

  void spread() {
    const Hubs hubs = Hubs::ofWalks(anchors_.mesh());
    std::vector<Vertex> waiting;
    for (std::size_t head = 0; head < reached_.size() || !waiting.empty();) {
      const bool isLast = head == reached_.size();
      const Vertex from = isLast ? waiting.back() : reached_[head++];
      if (isLast) waiting.pop_back();
      if (!isLast && hubs.contains(from))
        waiting.push_back(from);
      else
        spreadFrom(from);
    }
  }

  const Anchors& anchors_;
  VertexData<Vertex> near_;
  std::vector<Vertex> reached_;
};

class Survey {
 public:
  Survey(const Run& run, double enough, double surely)
      : run_(run),
        enough_(enough),
        surely_(surely),
        mesh_(run.mesh),
        hubs_(Hubs::ofWalks(run.mesh.mesh())),
        anchors_(run),
        nearby_(run.mesh, anchors_),
        near_(anchors_.mesh().vertexCapacity(), 0) {}

  std::vector<Place> places() {
    const HalfedgeMesh& anchors = anchors_.mesh();
    for (Index i = 0; i < anchors.vertexCapacity(); ++i) {
      const Vertex anchor(i);
      if (!anchors.isAlive(anchor) || !nearby_[anchor]) continue;
      const Vertex v = anchors_.original(anchor), w = nearby_[anchor];
      near_[anchor] = isSurelyNear(v, w);
      if (!near_[anchor]) add(mesh_.surface().at(v), faceAt(w));
    }
    addInside();
    return std::move(places_);
  }

 private:
  // Whether v, of the original, lies near the tangent plane of w, of the mesh, and faces the same
  // way. This test spares most places a walk.
  bool isSurelyNear(Vertex v, Vertex w) const {
    // A boundary's tangent plane goes on where the mesh does not.
    if (mesh_.kind(w) != VertexKind::Interior || mesh_.surface().mesh().isBoundary(v)) return false;
    const Vec3 offset = mesh_.surface().positions()[v] - mesh_.position(w);
    const double size = run_.asked.scale * run_.sizes.at(mesh_.at(w));
    return offset.squaredNorm() < size * size &&
           std::abs(offset.dot(mesh_.normal(w))) < surely_ * size;
  }

  Face faceAt(Vertex v) const { return HalfedgeMesh::face(mesh_.mesh().outgoing(v)); }

  bool isDoubtful(const Place& place, double size) const {
    return place.distance >= std::max(kDoubtful, enough_) * size ||
           (place.distance >= enough_ * size && isAcrossEdge(place));
  }

  // Whether the nearest triangle faces away from the original's: a walk over a wedge ends at the
  // foot of the perpendicular on the wedge's other side.
  bool isAcrossEdge(const Place& place) const {
    const auto [a, b, c] = mesh_.surface().mesh().vertices(place.original.face);
    const VertexData<Vec3>& p = mesh_.surface().positions();
    const Triangle t = mesh_.corners(place.nearest);
    return areaVector(p[a], p[b], p[c]).dot(areaVector(t[0], t[1], t[2])) < 0;
  }

  // Walks again from all around where the last walk ended, except around hubs. Each start is used
  // once, since all walks from it end alike.
  void retry(Place& place, double size) {
    const HalfedgeMesh& mesh = mesh_.mesh();
    starts_.clear();
    for (bool improved = true; improved && isDoubtful(place, size);) {
      improved = false;
      for (const Vertex v : mesh.vertices(place.nearest)) {
        if (hubs_.contains(v)) continue;
        mesh.forEachNeighbor(v, [&](Vertex w) {
          const Face start = faceAt(w);
          if (std::find(starts_.begin(), starts_.end(), start) != starts_.end()) return;
          starts_.push_back(start);
          improved = improve(mesh_, place, {start, enough_ * size}) || improved;
        });
      }
    }
  }

  // Returns the triangle nearest to the place, or one that is near enough.
  Face add(const SurfacePoint& original, Face start) {
    const double size = run_.asked.scale * run_.sizes.at(original);
    Place place{original, mesh_.surface().position(original), start, kInfinity};
    improve(mesh_, place, {start, enough_ * size});
    retry(place, size);
    if (isDoubtful(place, size)) {
      if (!tree_) tree_.emplace(mesh_.mesh(), mesh_.positions());
      const MeshTree::Nearest nearest = tree_->nearest(place.position, place.nearest);
      place.nearest = nearest.face;
      place.distance = nearest.distance;
    }
    if (place.distance >= enough_ * size) places_.push_back(place);
    return place.nearest;
  }

  // Steps of half a target edge length along the sides of a triangle, and in rows between the
  // longest and the corner opposite.
  struct Grid {
    int longest = 0;  // the corner where that side begins
    double along = 0, rows = 0;

    double places() const { return 0.5 * (along + 1) * (rows + 1); }
    bool hasPlaces() const { return along >= 2; }
  };

  using Grids = FaceData<Grid>;

  // From several places: one copy is enough.
  [[gnu::noinline]] double squaredLengthOf(Face f, int side) const {
    const HalfedgeMesh& original = mesh_.surface().mesh();
    const VertexData<Vec3>& positions = mesh_.surface().positions();
    const Halfedge h = HalfedgeMesh::halfedge(f, side);
    return (positions[original.tip(h)] - positions[original.origin(h)]).squaredNorm();
  }

  double lengthOf(Face f, int side) const { return std::sqrt(squaredLengthOf(f, side)); }

  Grid gridOf(Face f) const {
    const auto corners = mesh_.surface().mesh().vertices(f);
    const VertexData<Vec3>& p = mesh_.surface().positions();
    const std::array<double, 3> squared = {squaredLengthOf(f, 0), squaredLengthOf(f, 1),
                                           squaredLengthOf(f, 2)};
    const double largest = greatest(squared[0], squared[1], squared[2]);
    const double size = run_.asked.scale * run_.sizes.at(corners[0]);
    const auto isNear = [this](Vertex v) { return near_[anchors_.near(v)] != 0; };
    if (std::all_of(corners.begin(), corners.end(), isNear)) return {};
    const auto side = int(std::find(squared.begin(), squared.end(), largest) - squared.begin());
    const double longest = std::sqrt(largest);
    const double steps = std::ceil(longest / (kSpacing * size));
    if (!(steps > 1) || !nearby_[anchors_.near(corners[0])]) return {};
    const double height = areaVector(p[corners[0]], p[corners[1]], p[corners[2]]).norm() / longest;
    return {side, steps, std::max(1.0, std::ceil(height / (kSpacing * size)))};
  }

  // Sound triangles ask for a few places per vertex of the mesh, since both numbers grow with the
  // area. Triangles with sides much longer than their area suggests could ask for any number. Then
  // all steps are made longer, and the work stays in proportion to both meshes.
  void addInside() {
    Grids grids(mesh_.surface().mesh().faceCapacity());
    const double most = kMostPlaces * double(mesh_.mesh().vertexCount() + grids.size());
    double places = 0;
    for (Index i = 0; i < grids.size(); ++i) {
      grids[Face(i)] = gridOf(Face(i));
      places += grids[Face(i)].places();
    }
    if (places > most) fires("accuracy samples: steps made longer");
    for (Grid& grid : grids.values()) {
      if (places > most) grid.along = std::floor(grid.along * most / places);
      grid.rows = std::min(grid.rows, most);
    }
    for (Index i = 0; i < grids.size(); ++i)
      if (grids[Face(i)].hasPlaces()) addOver(Face(i), grids);
  }

  // The face where walks over f begin; not at a hub, where a walk would look at all faces around
  // it.
  Face startFor(Face f) const {
    const auto corners = mesh_.surface().mesh().vertices(f);
    for (const Vertex v : corners)
      if (const Vertex w = nearby_[anchors_.near(v)]; w && !hubs_.contains(w)) return faceAt(w);
    return faceAt(nearby_[anchors_.near(corners[0])]);
  }

  // A side that two triangles share is looked at once.
  void addOver(Face f, const Grids& grids) {
    const HalfedgeMesh& original = mesh_.surface().mesh();
    const auto& [longest, along, rows] = grids[f];
    Face start = startFor(f);
    for (int i = 0; i < 3; ++i) {
      const Halfedge twin = original.twin(HalfedgeMesh::halfedge(f, i));
      if (twin && HalfedgeMesh::face(twin) < f && grids[HalfedgeMesh::face(twin)].hasPlaces())
        continue;
      start = addRow({f, i}, 0, std::ceil(along * lengthOf(f, i) / lengthOf(f, longest)), start);
    }
    for (int row = 1; row < rows; ++row) {
      const double up = row / rows;
      start = addRow({f, longest}, up, std::ceil(along * (1 - up)), start);
    }
  }

  struct Side {
    Face face;
    int corner;  // where it begins
  };

  // Adds a row of places between the other two sides, at the share `up` of the way from this side
  // to the opposite corner.
  Face addRow(const Side& side, double up, double steps, Face start) {
    for (int step = 1; step < steps; ++step) {
      const double on = (1 - up) * step / steps;
      Vec3 weights;
      weights[side.corner] = 1 - up - on;
      weights[(side.corner + 1) % 3] = on;
      weights[(side.corner + 2) % 3] = up;
      start = add({side.face, weights}, start);
    }
    return start;
  }

  const Run& run_;
  const double enough_, surely_;
  const WorkingMesh& mesh_;
  const Hubs hubs_;
  const Anchors anchors_;
  const NearbyVertices nearby_;
  // For the few places whose nearest triangle no walk finds: those inside triangles of the original
  // far larger than the mesh's.
  std::optional<MeshTree> tree_;
  VertexData<char> near_;     // surely, per anchor
  std::vector<Face> starts_;  // of the walks to the place at hand
  std::vector<Place> places_;
};

}  // namespace

std::vector<Place> measurePlaces(const Run& run, double enough, double surely) {
  return Survey(run, enough, surely).places();
}

}  // namespace remesher
