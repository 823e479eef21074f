// SPDX-License-Identifier: MIT
// The curves that a remeshed surface must follow: sharp edges, open boundaries, seams. They form a
// graph on the original: chains of edges from corner to corner. A closed curve is divided at three
// to six of its vertices, which become corners. So every chain is an open path between two
// different corners, a place on it is one number, and no loop ever shrinks below a triangle.
#pragma once

#include <vector>

#include "geometry/surface_point.h"
#include "original/curves/chain_tracing.h"

namespace remesher {

struct CurvePoint {
  Index chain = kNone;
  double arc = 0;  // length along the chain from its first corner, model units
};

class FeatureCurves {
 public:
  FeatureCurves() = default;
  FeatureCurves(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                const CurveRules& rules);

  // The same curves on a mesh that replaces the old one and keeps all curve vertices and edges.
  // collapseMap: per old vertex the new one that it was collapsed into. Places on the curves stay
  // the same.
  FeatureCurves(const HalfedgeMesh& mesh, const FeatureCurves& other,
                const VertexData<Vertex>& collapseMap);

  const std::vector<Chain>& chains() const { return chains_; }
  bool isCurve(Halfedge h) const { return chainOf_[h] != kNone; }
  Index chain(Halfedge h) const { return chainOf_[h]; }
  bool isCorner(Vertex v) const { return corner_[v]; }

  struct Place {
    Vec3 position;
    SurfacePoint at;  // in the face of the halfedge that the chain names
    Halfedge edge;    // the original edge it lies on
  };
  Place locate(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
               const CurvePoint& point) const;

  // `here` as a point of the face to the left of the path from `here` to `there` on the same chain.
  SurfacePoint leftOf(const HalfedgeMesh& mesh, const CurvePoint& here,
                      const CurvePoint& there) const;

  // The end of the chain at corner `v`.
  CurvePoint atCorner(Index chain, Vertex v) const;

 private:
  void nameChains(const HalfedgeMesh& mesh);
  struct Step {
    Halfedge edge;
    double fraction;  // of the way from the chain's vertex i to i + 1
    std::size_t i;
  };
  Step step(const CurvePoint& point, double towards) const;

  std::vector<Chain> chains_;
  HalfedgeData<Index> chainOf_;
  VertexData<char> corner_;
};

}  // namespace remesher
