// SPDX-License-Identifier: MIT
#include "remesh/ground/proxy.h"

#include <utility>

#include "original/surface/surface_walk.h"
#include "remesh/ground/decimate.h"

namespace remesher {

struct Proxy::Parts {
  BuiltMesh built;
  FeatureCurves curves;
  VertexData<Vertex> collapseMap, onOriginal;
};

namespace {

// Per remaining vertex the original vertex that it is; each has kept its place.
VertexData<Vertex> ancestors(const WorkingMesh& thinned) {
  VertexData<Vertex> result(thinned.mesh().vertexCapacity());
  for (Index i = 0; i < result.size(); ++i) {
    result[Vertex(i)] = thinned.originalCorner(thinned.at(Vertex(i)));
  }
  return result;
}

}  // namespace

Proxy::Proxy(const OriginalSurface& original, double edge)
    : Proxy(original, [&] {
        WorkingMesh mesh(original);
        const VertexData<double> spacing(mesh.mesh().vertexCapacity(), edge);
        VertexData<Vertex> collapseMap = decimate(mesh, FidelityRule{}, spacing);
        VertexData<Vertex> onOriginal = ancestors(mesh);
        BuiltMesh built;
        built.mesh = mesh.mesh();
        built.positions = mesh.positions();
        for (const Vertex v : onOriginal.values())
          built.sources.values().push_back(original.built().sources[v]);
        FeatureCurves curves(built.mesh, original.curves(), collapseMap);
        return Parts{std::move(built), std::move(curves), std::move(collapseMap),
                     std::move(onOriginal)};
      }()) {}

Proxy::Proxy(const OriginalSurface& original, Parts&& thinned)
    : original_(&original),
      collapseMap_(std::move(thinned.collapseMap)),
      onOriginal_(std::move(thinned.onOriginal)),
      surface_(std::move(thinned.built), std::move(thinned.curves)) {}

// Takes the nearest end of three walks, from the places of the three corners.
SurfacePoint Proxy::onOriginal(const SurfacePoint& p) const {
  const Vec3 target = surface_.position(p);
  SurfacePoint best;
  double shortest = kInfinity;
  for (const Vertex corner : surface_.mesh().vertices(p.face)) {
    const SurfacePoint found =
        closestPointFrom(*original_, original_->at(onOriginal_[corner]), target);
    const double distance = (original_->position(found) - target).squaredNorm();
    if (distance >= shortest) continue;
    shortest = distance;
    best = found;
  }
  return best;
}

}  // namespace remesher
