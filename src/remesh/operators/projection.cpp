// SPDX-License-Identifier: MIT
#include "remesh/operators/projection.h"

#include "original/surface/surface_walk.h"

namespace remesher {

namespace {

// Of a patch around its cell, in edges: see PatchAtlas.
constexpr double kMargin = 1.5;

}  // namespace

Projector::Projector(const OriginalSurface& surface, Projection mode, double reach)
    : surface_(&surface),
      mode_(mode),
      atlas_(std::in_place, surface.mesh(), surface.positions(), kMargin * reach,
             surface.barriers()) {}

void Projector::moveOnto(const OriginalSurface& surface) {
  surface_ = &surface;
  atlas_.reset();
}

// Projects through a patch. If none serves, it walks from the three corners and takes the first
// walk that ends plainly near, or else the one that ends nearest.
SurfacePoint Projector::onOriginal(const std::array<SurfacePoint, 3>& corners,
                                   const Triangle& places, const Vec3& weights) {
  if (mode_ == Projection::Patches && atlas_)
    if (const auto point = atlas_->interpolate(corners, places, weights)) return *point;
  const Vec3 flat = weights[0] * places[0] + weights[1] * places[1] + weights[2] * places[2];
  SurfacePoint best;
  double bestDistance = kInfinity;
  // A walk that ends plainly near has found what walks from other corners would.
  const double enough = kPlainlyNear * kPlainlyNear * (places[1] - places[0]).squaredNorm();
  for (int i = 0; i < 3 && bestDistance > enough; ++i) {
    if (weights[i] <= 0) continue;
    const SurfacePoint point = closestPointFrom(*surface_, corners[i], flat);
    const double distance = (surface_->position(point) - flat).squaredNorm();
    if (distance < bestDistance) {
      bestDistance = distance;
      best = point;
    }
  }
  return best;
}

Placement Projector::project(const WorkingMesh& mesh, Halfedge h, const Vec3& weights) {
  const Halfedge n = mesh.mesh().next(h), p = mesh.mesh().prev(h);
  const Triangle places = {mesh.position(mesh.mesh().origin(h)),
                           mesh.position(mesh.mesh().origin(n)),
                           mesh.position(mesh.mesh().origin(p))};
  const SurfacePoint point =
      onOriginal({mesh.cornerPoint(h), mesh.cornerPoint(n), mesh.cornerPoint(p)}, places, weights);
  Placement place = mesh.onSurface(point);
  if (mode_ == Projection::Current)
    place.position = weights[0] * places[0] + weights[1] * places[1] + weights[2] * places[2];
  return place;
}

}  // namespace remesher
