// SPDX-License-Identifier: MIT
// A surface as the facets that it is made of, with a triangulation of its own: the edges between
// facets stay where they are, and all vertices lie on the original. The triangles within a facet
// may change, in its plane, as may the places of vertices along the straight edges. Facets that
// bend little against each other may be unrolled, and are one facet then.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/surface_point.h"
#include "mesh/euler_operators.h"
#include "mesh/mesh_builder.h"
#include "original/curves/feature_curves.h"
#include "remesh/conforming/unrolled.h"

namespace remesher {

// A corner of facets stays; on a line between two facets, or on a boundary, a vertex may slide;
// inside a facet it is free.
enum class FacetRole : char { Free, OnLine, Corner };

// Limits of edges, in model units.
struct FacetLimits {
  double depth = 0;  // largest distance from the original through unrolled facets; 0: none
                     // are unrolled
  double longest = kInfinity;  // longer edges are divided first
};

class FacetedMesh {
 public:
  // seams: edges that stay edges, even within a plane. The original must outlive the object.
  FacetedMesh(const BuiltMesh& original, const HalfedgeData<char>& seams,
              const FacetLimits& limits = {});
  FacetedMesh(const FacetedMesh&) = default;
  FacetedMesh& operator=(const FacetedMesh&) = delete;

  const HalfedgeMesh& mesh() const { return mesh_; }
  const VertexData<Vec3>& positions() const { return positions_; }
  const FeatureCurves& curves() const { return curves_; }
  FacetRole role(Vertex v) const { return role_[v]; }
  Index facet(Face f) const { return facet_[f]; }
  // Whether the edge lies on a line between facets or on a boundary.
  bool isLine(Halfedge h) const { return line_[h] != kNone; }
  // Whether an edge on a line must stay: the builder cut the surface apart there.
  bool isKept(Halfedge h) const { return curves_.chains()[line_[h]].kept; }
  // Whether a seam ends within a plane: then a place there is on no definite side of it.
  bool hasOpenSeam() const;
  // Whether no triangle is turned over in the plane of its facet, or a line there.
  bool isSound() const;

  // In the plane of a facet, lengths in model units.
  Vec2 flat(Vertex v, Index facet) const {
    return isBent(facet) ? unrolled(v, facet) : frames_[facet].flat(positions_[v]);
  }
  // Whether facets were unrolled to this one.
  bool isBent(Index facet) const { return unrolled_.isBent[facet]; }
  bool hasBent() const;
  // The point of the original halfway between two vertices of an unrolled facet.
  Vec3 halfway(Vertex a, Vertex b, Index facet) const;
  // Moves a vertex off the original. Its place there stays the same.
  void lift(Vertex v, const Vec3& way) {
    positions_[v] += way;
    known_[v] = {};
  }
  // How far edges through unrolled facets may be from them.
  double depth() const { return limits_.depth; }
  // From which length on edges are divided first.
  double longest() const { return limits_.longest; }
  // Whether an edge through the facet would be farther from it than it may be.
  bool isDeep(Vertex a, Vertex b, Index facet) const;
  // 1 if the triangle is counterclockwise in the plane, as those of the original are.
  int turn(Vertex a, Vertex b, Vertex c, Index facet) const;
  int turn(Face f) const;

  // Whether a halfedge of two triangles of one facet that form a convex quadrilateral.
  bool canFlip(Halfedge h) const;
  void flip(Halfedge h);
  // A new vertex in the face, as near as the original has a point to `place`. None if a triangle
  // would not be counterclockwise.
  Vertex divide(Face f, const Vec2& place);
  // A new vertex on a line, this share of the way along it.
  Vertex split(Halfedge h, double share);
  // Moves the origin of h into its tip, along a line if it lies on one, unless a triangle would
  // turn over. Returns whether it has.
  bool collapse(Halfedge h);

  // A free vertex.
  void move(Vertex v, const Vec2& place, Index facet);
  // Where a vertex on a line may slide: the arcs of its neighbors there, and its own.
  struct Reach {
    double from, at, to;
  };
  Reach reach(Vertex v) const;
  void slide(Vertex v, double arc);

  // The vertex as a point of a triangle of the original within the facet.
  SurfacePoint pointIn(Vertex v, Index facet) const;

 private:
  struct Frame {
    Vec3 origin = Vec3::Zero(), u = Vec3::Zero(), v = Vec3::Zero();
    Vec2 flat(const Vec3& p) const { return {u.dot(p - origin), v.dot(p - origin)}; }
  };
  struct Place {
    SurfacePoint at;
    Vec3 position;
  };
  // Places of a vertex in unrolled facets, those last asked for.
  struct FlatPlace {
    Index facet = kNone;
    Vec2 at = Vec2::Zero();
  };
  using FlatPlaces = std::array<FlatPlace, 2>;

  void setFacets(const HalfedgeData<char>& seams);
  void unroll(const HalfedgeData<char>& seams);
  void setFrames();
  void setRoles(const HalfedgeData<char>& seams);
  void grow();
  Vertex splitOff(Halfedge h);
  Vertex splitEdge(Halfedge h);
  bool staysTurned(Halfedge h) const;
  double arcOf(Vertex v, Index chain) const;
  std::optional<SurfacePoint> across(const SurfacePoint& point, Index facet) const;
  Vec2 unrolled(Vertex v, Index facet) const;
  // Of a corner of a face of the original.
  Vec2 ownFlat(Face f, int corner, Index facet) const;
  Vec2 flatOf(const SurfacePoint& point, Index facet) const;
  Vec3 weightsIn(Face f, const Vec2& place, Index facet) const;
  // In space, or where it is flat.
  SurfacePoint nearestIn(Index facet, const Vec3& place, bool isFlat) const;
  // The point of the original within the facet at `place`, looked for from a point of it.
  Place placeAt(const Vec2& place, Index facet, Face start) const;
  void put(Vertex v, FacetRole role, const Place& place);

  const BuiltMesh& original_;
  FacetLimits limits_;
  FaceData<Index> ownFacet_;  // per face of the original
  Unrolled unrolled_;
  std::vector<Frame> frames_;
  std::vector<std::vector<Face>> faces_;  // of the original, by facet
  FeatureCurves curves_;                  // the lines between facets, straight each
  HalfedgeMesh mesh_;
  VertexData<Vec3> positions_;
  VertexData<SurfacePoint> at_;  // on the original
  mutable VertexData<FlatPlaces> known_;
  VertexData<FacetRole> role_;
  VertexData<Vertex> source_;     // of corners: the vertex of the original
  VertexData<CurvePoint> along_;  // of vertices on lines
  FaceData<Index> facet_;
  HalfedgeData<Index> line_;  // the curve along each edge, or kNone
};

}  // namespace remesher
