// SPDX-License-Identifier: MIT
// A query tries the patch of the heaviest corner's cell, then those of the other corners' cells,
// and last a patch grown around just these three faces, as the report does for every query; such
// patches are kept and shared, and the work spent on them is bounded.
#include "surface/patch_atlas.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "surface/disk_parameterization.h"
#include "surface/disk_patch.h"
#include "surface/face_cells.h"
#include "surface/point_location.h"

namespace remesher {
namespace {

// Faces of a cell. Larger cells make fewer, larger patches whose maps are more distorted.
constexpr std::size_t kCellSize = 100;

// The margin takes no face whose normal points this far back (cosine to the cell's mean normal).
constexpr float kMarginCone = -0.3f;

// However small the margin, a patch reaches this many faces beyond its cell, so that it holds the
// star of each of the cell's vertices.
constexpr int kMinReach = 3;

// A patch this large has outgrown its use; growth by breadth first keeps what is nearest.
constexpr std::size_t kMaxPatchFaces = 3000;

// A point thrown farther from the flat triangle than this share of its longest side is refused:
// the map is too distorted there.
constexpr double kMaxThrow = 0.25;

// That and rounding, a share of the bounding box's diagonal: corners may fall together.
constexpr double kRoundingShare = 1e-9;

// Faces that all patches grown on demand may visit together, per face of the mesh, and at least.
constexpr std::size_t kOnDemandShare = 4;
constexpr std::size_t kMinOnDemandFaces = 100000;

// A patch on demand reaches this many times the distance between the corners.
constexpr float kOnDemandReach = 1.3f;

double squaredRounding(const VertexData<Vec3>& positions) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : positions.values()) box.extend(p);
  return box.isEmpty() ? 0 : kRoundingShare * kRoundingShare * box.diagonal().squaredNorm();
}

}  // namespace

struct PatchAtlas::Impl {
  Impl(const HalfedgeMesh& m, const VertexData<Vec3>& p, double marginLength, HalfedgeData<char> b)
      : mesh(m),
        positions(p),
        barriers(std::move(b)),
        margin(float(marginLength)),
        frames(faceFrames(mesh, positions)),
        roundingSquared(squaredRounding(positions)),
        cells(partitionFaces(mesh, frames, barriers.values(), kCellSize)),
        grower(mesh, barriers.values()),
        patches(cells.count()),
        isBuilt(cells.count(), 0),
        onDemandBudget(std::max(kMinOnDemandFaces, kOnDemandShare * mesh.faceCapacity())) {}

  Vec3 position(const SurfacePoint& p) const {
    const auto [a, b, c] = mesh.vertices(p.face);
    return p.barycentric[0] * positions[a] + p.barycentric[1] * positions[b] +
           p.barycentric[2] * positions[c];
  }

  void growCore(Index cell);
  void growMargin();
  void growAround(const std::array<SurfacePoint, 3>& corners);
  PlanarPatch finish(std::span<const Face> kept);
  const PlanarPatch& patchOfCell(Index cell);
  const PlanarPatch* patchOnDemand(const std::array<SurfacePoint, 3>& corners);

  std::optional<SurfacePoint> mix(const PlanarPatch& patch,
                                  const std::array<SurfacePoint, 3>& corners,
                                  const Vec3& weights) const;

  const HalfedgeMesh& mesh;
  const VertexData<Vec3>& positions;
  const HalfedgeData<char> barriers;
  const float margin;
  const FaceData<FaceFrame> frames;
  const double roundingSquared;
  const FaceCells cells;

  DiskGrower grower;
  DiskParameterizer parameterizer;
  struct Reach {
    Face source;  // the cell's face this one was reached from
    int steps;
  };
  std::vector<Reach> reaches;  // of the grower's faces

  std::vector<PlanarPatch> patches;  // of the cells; empty where no usable one was found
  std::vector<char> isBuilt;
  std::vector<PlanarPatch> extraPatches;  // on demand
  FaceData<Index> extraPatch;             // the last of them that holds the face
  std::size_t onDemandBudget;
};

void PatchAtlas::Impl::growCore(Index cell) {
  const std::span<const Face> core = cells.faces(cell);
  grower.clear();
  grower.add(core[0]);
  for (std::size_t head = 0; head < grower.faces().size(); ++head) {
    const Face f = grower.faces()[head];
    for (int i = 0; i < 3; ++i) {
      const Face g = grower.neighbor(HalfedgeMesh::halfedge(f, i));
      if (g && cells.cellOf(g) == cell) grower.add(g);
    }
  }
}

void PatchAtlas::Impl::growMargin() {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  reaches.clear();
  for (const Face f : grower.faces()) {
    normal += frames[f].normal;
    reaches.push_back({f, 0});
  }
  const float lowest = kMarginCone * normal.norm();
  for (std::size_t head = 0; head < grower.faces().size(); ++head) {
    if (grower.faces().size() >= kMaxPatchFaces) break;
    const Reach from = reaches[head];
    const Face f = grower.faces()[head];
    for (int i = 0; i < 3; ++i) {
      const Face g = grower.neighbor(HalfedgeMesh::halfedge(f, i));
      if (!g || grower.holds(g) || frames[g].normal.dot(normal) < lowest) continue;
      const float distance = (frames[g].centroid - frames[from.source].centroid).norm();
      if (distance > margin && from.steps >= kMinReach) continue;
      if (grower.add(g)) reaches.push_back({from.source, from.steps + 1});
    }
  }
}

// Breadth first from one corner's face, within a ball about the triangle.
void PatchAtlas::Impl::growAround(const std::array<SurfacePoint, 3>& corners) {
  const Vec3 p = position(corners[0]), q = position(corners[1]), r = position(corners[2]);
  const double side = std::max({(q - p).norm(), (r - q).norm(), (p - r).norm()});
  const Eigen::Vector3f centre = ((p + q + r) / 3).cast<float>();
  const float reach = kOnDemandReach * float(side);
  reaches.clear();
  grower.clear();
  grower.add(corners[0].face);
  reaches.push_back({corners[0].face, 0});
  for (std::size_t head = 0; head < grower.faces().size(); ++head) {
    if (grower.faces().size() >= kMaxPatchFaces) break;
    const Face f = grower.faces()[head];
    const int steps = reaches[head].steps;
    for (int i = 0; i < 3; ++i) {
      const Face g = grower.neighbor(HalfedgeMesh::halfedge(f, i));
      if (!g || grower.holds(g)) continue;
      if (steps >= kMinReach && (frames[g].centroid - centre).norm() > reach) continue;
      if (grower.add(g)) reaches.push_back({g, steps + 1});
    }
  }
}

PlanarPatch PatchAtlas::Impl::finish(std::span<const Face> kept) {
  grower.trimEars(kept);
  const DiskPatch* disk = grower.cut();
  if (!disk) return {};
  const std::span<const Uv> uv = parameterizer.solve(*disk, positions);
  return uv.empty() ? PlanarPatch() : PlanarPatch(*disk, uv);
}

const PlanarPatch& PatchAtlas::Impl::patchOfCell(Index cell) {
  if (!isBuilt[cell]) {
    isBuilt[cell] = 1;
    growCore(cell);
    const std::size_t coreCount = grower.faces().size();
    growMargin();
    patches[cell] = finish(grower.faces().first(coreCount));
  }
  return patches[cell];
}

// A failed attempt costs as much as a good one: both are charged to the budget.
const PlanarPatch* PatchAtlas::Impl::patchOnDemand(const std::array<SurfacePoint, 3>& corners) {
  if (extraPatch.size() == 0) extraPatch.resize(mesh.faceCapacity(), kNone);
  const auto holdsAll = [&](const PlanarPatch& patch) {
    return std::all_of(corners.begin(), corners.end(),
                       [&](const SurfacePoint& c) { return patch.find(c.face.index) != kNoLocal; });
  };
  for (const SurfacePoint& corner : corners) {
    const Index shared = extraPatch[corner.face];
    if (shared != kNone && holdsAll(extraPatches[shared])) return &extraPatches[shared];
  }
  if (onDemandBudget == 0) return nullptr;
  growAround(corners);
  onDemandBudget -= std::min(onDemandBudget, grower.faces().size());
  if (!std::all_of(corners.begin(), corners.end(),
                   [&](const SurfacePoint& c) { return grower.holds(c.face); }))
    return nullptr;
  const std::array<Face, 3> kept = {corners[0].face, corners[1].face, corners[2].face};
  PlanarPatch patch = finish(kept);
  if (patch.isEmpty() || !holdsAll(patch)) return nullptr;
  for (const LocalFace& f : patch.faces()) extraPatch[Face(f.face)] = Index(extraPatches.size());
  extraPatches.push_back(std::move(patch));
  return &extraPatches.back();
}

// None if the patch does not hold all corners or throws the point too far.
std::optional<SurfacePoint> PatchAtlas::Impl::mix(const PlanarPatch& patch,
                                                  const std::array<SurfacePoint, 3>& corners,
                                                  const Vec3& weights) const {
  Vec2 target = Vec2::Zero();
  LocalIndex start = kNoLocal;
  double heaviest = -1;
  for (int i = 0; i < 3; ++i) {
    const LocalIndex local = patch.find(corners[i].face.index);
    if (local == kNoLocal) return std::nullopt;
    target += weights[i] * patch.image(local, corners[i].barycentric);
    if (weights[i] <= heaviest) continue;
    heaviest = weights[i];
    start = local;
  }
  const PlanarPatch::Location found = patch.locate(target, start);
  const SurfacePoint point{Face(patch.faces()[found.face].face), found.barycentric};

  const Vec3 p = position(corners[0]), q = position(corners[1]), r = position(corners[2]);
  const Vec3 flat = weights[0] * p + weights[1] * q + weights[2] * r;
  const double side =
      std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()});
  const double allowed = kMaxThrow * kMaxThrow * side + roundingSquared;
  if ((position(point) - flat).squaredNorm() > allowed) return std::nullopt;
  return point;
}

PatchAtlas::PatchAtlas(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, double margin,
                       HalfedgeData<char> barriers)
    : impl_(std::make_unique<Impl>(mesh, positions, margin, std::move(barriers))) {}
PatchAtlas::~PatchAtlas() = default;
PatchAtlas::PatchAtlas(PatchAtlas&&) noexcept = default;

std::optional<SurfacePoint> PatchAtlas::interpolate(const std::array<SurfacePoint, 3>& corners,
                                                    const Vec3& weights) {
  int heaviest = 0;
  weights.maxCoeff(&heaviest);
  for (int i = 0; i < 3; ++i) {
    const Face home = corners[(heaviest + i) % 3].face;
    const PlanarPatch& patch = impl_->patchOfCell(impl_->cells.cellOf(home));
    if (patch.isEmpty()) continue;
    if (const auto point = impl_->mix(patch, corners, weights)) return point;
  }
  const PlanarPatch* patch = impl_->patchOnDemand(corners);
  return patch ? impl_->mix(*patch, corners, weights) : std::nullopt;
}

}  // namespace remesher
