// SPDX-License-Identifier: MIT
// A query tries the patch of its heaviest corner's cell, then the patches of the other corners'
// cells. If none holds all corners or maps them well, it tries a patch made for the three faces.
// These patches are kept and shared, and the work spent on them is bounded.
#include "original/patches/patch_atlas.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"
#include "original/patches/patch_builder.h"

namespace remesher {
namespace {

// A distorted map throws points along the surface. A point is refused if its distance from the flat
// triangle exceeds these shares of the longest side: kMaxSlide along the triangle, where there is
// no reason to move, kMaxThrow in all, where the surface may bulge.
constexpr double kMaxSlide = 0.3, kMaxThrow = 0.5;

// All on-demand patches together may visit as many faces as the mesh has, and at least so many.
constexpr std::size_t kMinOnDemandFaces = 100000;

// A patch on demand reaches this many times its triangle's longest side from the centroid.
constexpr double kOnDemandReach = 1.3;

// Triangles with a corner this near to the middle of its disk share the patch: farther out it may
// hold the corners and yet be of little use.
constexpr double kCentral = 0.6;

double diagonal(const VertexData<Vec3>& positions) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : positions.values()) box.extend(p);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

double squaredLongestSide(const Triangle& t) {
  return std::max(
      {(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()});
}

}  // namespace

struct PatchAtlas::Impl {
  Impl(const HalfedgeMesh& m, const VertexData<Vec3>& p, double margin, HalfedgeData<char> b)
      : mesh(m),
        positions(p),
        barriers(std::move(b)),
        // Corners may coincide.
        squaredRounding(std::pow(kRoundOff * diagonal(positions), 2)),
        builder(mesh, positions, barriers.values(), margin),
        patches(builder.cells().count()),
        isBuilt(patches.size(), 0),
        ownNumber(mesh.faceCapacity(), kNoLocal),
        onDemandBudget(std::max(kMinOnDemandFaces, std::size_t(mesh.faceCapacity()))) {}

  Vec3 position(const SurfacePoint& p) const {
    const auto [a, b, c] = mesh.vertices(p.face);
    return p.barycentric[0] * positions[a] + p.barycentric[1] * positions[b] +
           p.barycentric[2] * positions[c];
  }

  const PlanarPatch& patchAt(Face f);
  std::array<LocalIndex, 3> findIn(Index cell, const std::array<SurfacePoint, 3>& corners) const;
  const PlanarPatch* patchOnDemand(const std::array<SurfacePoint, 3>& corners,
                                   const Triangle& triangle);
  bool isThrown(const Vec3& point, const Triangle& triangle, const Vec3& weights) const;

  const HalfedgeMesh& mesh;
  const VertexData<Vec3>& positions;
  const HalfedgeData<char> barriers;
  const double squaredRounding;
  PatchBuilder builder;
  std::vector<PlanarPatch> patches;  // per cell; empty if no usable one was found
  std::vector<char> isBuilt;
  FaceData<LocalIndex> ownNumber;  // per face its number in the patch of its cell, once built
  std::vector<PlanarPatch> extraPatches;  // on demand
  FaceData<Index> extraPatch;             // per face the last of these around it, or kNone
  const std::size_t onDemandBudget;
};

namespace {

using LocalCorners = std::array<LocalIndex, 3>;

bool holdsAll(const LocalCorners& local) {
  return local[0] != kNoLocal && local[1] != kNoLocal && local[2] != kNoLocal;
}

LocalCorners findAll(const PlanarPatch& patch, const std::array<SurfacePoint, 3>& corners) {
  return {patch.find(corners[0].face.index), patch.find(corners[1].face.index),
          patch.find(corners[2].face.index)};
}

int heaviest(const Vec3& weights) {
  const int index = weights[1] > weights[0] ? 1 : 0;
  return weights[2] > weights[index] ? 2 : index;
}

SurfacePoint mix(const PlanarPatch& patch, const LocalCorners& local,
                 const std::array<SurfacePoint, 3>& corners, const Vec3& weights) {
  const Vec2 target = weights[0] * patch.image(local[0], corners[0].barycentric) +
                      weights[1] * patch.image(local[1], corners[1].barycentric) +
                      weights[2] * patch.image(local[2], corners[2].barycentric);
  const PlanarPatch::Location found = patch.locate(target, local[heaviest(weights)]);
  return {Face(patch.faces()[found.face].face), found.barycentric};
}

}  // namespace

const PlanarPatch& PatchAtlas::Impl::patchAt(Face f) {
  const Index cell = builder.cells().cellOf(f);
  if (!isBuilt[cell]) {
    isBuilt[cell] = 1;
    patches[cell] = builder.aroundCell(cell);
    const std::span<const LocalFace> faces = patches[cell].faces();
    for (std::size_t n = 0; n < faces.size(); ++n)
      if (builder.cells().cellOf(Face(faces[n].face)) == cell)
        ownNumber[Face(faces[n].face)] = LocalIndex(n);
  }
  return patches[cell];
}

// A fast look-up for the usual triangle, which lies inside one cell.
LocalCorners PatchAtlas::Impl::findIn(Index cell,
                                      const std::array<SurfacePoint, 3>& corners) const {
  LocalCorners local;
  for (int i = 0; i < 3; ++i) {
    const Face f = corners[i].face;
    const bool isOwn = builder.cells().cellOf(f) == cell;
    local[i] = isOwn ? ownNumber[f] : patches[cell].find(f.index);
  }
  return local;
}

// A failed attempt costs as much as a successful one: both are charged to the budget.
const PlanarPatch* PatchAtlas::Impl::patchOnDemand(const std::array<SurfacePoint, 3>& corners,
                                                   const Triangle& triangle) {
  if (extraPatch.size() == 0) extraPatch.resize(mesh.faceCapacity(), kNone);
  for (const SurfacePoint& corner : corners) {
    const Index shared = extraPatch[corner.face];
    if (shared != kNone && holdsAll(findAll(extraPatches[shared], corners)))
      return &extraPatches[shared];
  }
  if (builder.visitedFaces() >= onDemandBudget) return nullptr;
  const Vec3 centre = (triangle[0] + triangle[1] + triangle[2]) / 3;
  const double reach =
      kOnDemandReach * std::sqrt(squaredLongestSide(triangle));  // from the centroid
  // If the faces lie around a thin tube, the ways from one of them may close a ring: try each face.
  PlanarPatch patch;
  for (std::size_t i = 0; i < 3 && patch.isEmpty(); ++i)
    patch =
        builder.aroundFaces({corners[i].face, corners[(i + 1) % 3].face, corners[(i + 2) % 3].face},
                            {centre.cast<float>(), float(reach)});
  if (patch.isEmpty()) return nullptr;
  const Index number = Index(extraPatches.size());
  for (LocalIndex n = 0; n < patch.faces().size(); ++n)
    if (patch.image(n, Vec3::Constant(1.0 / 3)).norm() < kCentral)
      extraPatch[Face(patch.faces()[n].face)] = number;
  for (const SurfacePoint& corner : corners) extraPatch[corner.face] = number;
  extraPatches.push_back(std::move(patch));
  return &extraPatches.back();
}

bool PatchAtlas::Impl::isThrown(const Vec3& point, const Triangle& triangle,
                                const Vec3& weights) const {
  const Vec3 move =
      point - (weights[0] * triangle[0] + weights[1] * triangle[1] + weights[2] * triangle[2]);
  const double moved = move.squaredNorm();
  // A quick test for most points, which have hardly moved; any side serves as the measure.
  if (moved <= kMaxSlide * kMaxSlide * (triangle[1] - triangle[0]).squaredNorm()) return false;
  const double side = squaredLongestSide(triangle);
  if (moved > kMaxThrow * kMaxThrow * side + squaredRounding) return true;
  const Vec3 normal = areaVector(triangle[0], triangle[1], triangle[2]);
  const double height = normal.dot(move), length = normal.squaredNorm();
  const double bulge = length > 0 ? height * height / length : 0;
  return moved - bulge > kMaxSlide * kMaxSlide * side + squaredRounding;
}

PatchAtlas::PatchAtlas(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, double margin,
                       HalfedgeData<char> barriers)
    : impl_(std::make_unique<Impl>(mesh, positions, margin, std::move(barriers))) {}
PatchAtlas::~PatchAtlas() = default;
PatchAtlas::PatchAtlas(PatchAtlas&&) noexcept = default;

std::optional<SurfacePoint> PatchAtlas::interpolate(const std::array<SurfacePoint, 3>& corners,
                                                    const Vec3& weights) {
  const Triangle places = {impl_->position(corners[0]), impl_->position(corners[1]),
                           impl_->position(corners[2])};
  return interpolate(corners, places, weights);
}

std::optional<SurfacePoint> PatchAtlas::interpolate(const std::array<SurfacePoint, 3>& corners,
                                                    const Triangle& places, const Vec3& weights) {
  const int first = heaviest(weights);
  for (int i = 0; i < 3; ++i) {
    const Face middle = corners[(first + i) % 3].face;
    const PlanarPatch& patch = impl_->patchAt(middle);
    if (patch.isEmpty()) continue;
    const LocalCorners local = impl_->findIn(impl_->builder.cells().cellOf(middle), corners);
    if (!holdsAll(local)) continue;
    const SurfacePoint point = mix(patch, local, corners, weights);
    if (!impl_->isThrown(impl_->position(point), places, weights)) return point;
  }
  const PlanarPatch* patch = impl_->patchOnDemand(corners, places);
  if (!patch) return std::nullopt;
  const SurfacePoint point = mix(*patch, findAll(*patch, corners), corners, weights);
  if (impl_->isThrown(impl_->position(point), places, weights)) return std::nullopt;
  return point;
}

}  // namespace remesher
