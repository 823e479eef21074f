// SPDX-License-Identifier: MIT
#include "original/patches/patch_builder.h"

#include <algorithm>

#include "base/fires.h"
#include "geometry/triangle.h"

namespace remesher {
namespace {

// A cell has kMinCellSize faces, and kCellSizePerMargin more for each face that fits in a square as
// wide as the margin: else a patch would be mostly margin. Above kMaxCellSize maps are distorted.
constexpr double kMinCellSize = 100, kMaxCellSize = 400, kCellSizePerMargin = 2.5;

// A patch reaches this many faces beyond its cell, however small the margin, so that it holds the
// star of each of the cell's vertices.
constexpr int kMinReach = 3;

// A larger patch is of no use; breadth-first growth keeps the nearest faces.
constexpr std::size_t kMaxPatchFaces = 3000;

std::size_t cellSize(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, double margin) {
  double total = 0;
  for (Index i = 0; i < mesh.faceCapacity(); ++i) {
    if (!mesh.isAlive(Face(i))) continue;
    const auto [a, b, c] = mesh.vertices(Face(i));
    total += area(positions[a], positions[b], positions[c]);
  }
  const double inMargin = total > 0 ? margin * margin * double(mesh.faceCount()) / total : 0;
  return std::size_t(std::min(kMinCellSize + kCellSizePerMargin * inMargin, kMaxCellSize));
}

}  // namespace

PatchBuilder::PatchBuilder(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                           std::span<const char> barriers, double margin)
    : positions_(positions),
      margin_(float(margin)),
      frames_(faceFrames(mesh, positions)),
      cells_(partitionFaces(mesh, frames_, barriers, cellSize(mesh, positions, margin))),
      grower_(mesh, barriers) {}

void PatchBuilder::growCore(Index cell) {
  grower_.clear();
  grower_.add(cells_.faces(cell)[0]);
  for (std::size_t head = 0; head < grower_.faces().size(); ++head) {
    const Face f = grower_.faces()[head];
    for (int i = 0; i < 3; ++i) {
      const Face g = grower_.neighbor(HalfedgeMesh::halfedge(f, i));
      if (g && cells_.cellOf(g) == cell) grower_.add(g);
    }
  }
}

// Grows breadth first from the held faces. Every face within kMinReach steps is taken; farther out
// only faces for which isWanted(source, face) holds. source: the held face that growth came from.
template <class IsWanted>
void PatchBuilder::growOutwards(IsWanted isWanted) {
  reaches_.clear();
  for (const Face f : grower_.faces()) reaches_.push_back({f, 0});
  for (std::size_t head = 0; head < grower_.faces().size(); ++head) {
    if (grower_.faces().size() >= kMaxPatchFaces) {
      fires("patches: most faces");
      break;
    }
    const Reach from = reaches_[head];
    const Face f = grower_.faces()[head];
    for (int i = 0; i < 3; ++i) {
      const Face g = grower_.neighbor(HalfedgeMesh::halfedge(f, i));
      if (!g || grower_.holds(g)) continue;
      if (from.steps >= kMinReach && !isWanted(from.source, g)) continue;
      if (grower_.add(g)) reaches_.push_back({from.source, from.steps + 1});
    }
  }
}

void PatchBuilder::growMargin() {
  growOutwards([&](Face source, Face g) {
    return (frames_[g].centroid - frames_[source].centroid).norm() <= margin_;
  });
}

PlanarPatch PatchBuilder::finish(std::span<const Face> kept) {
  grower_.trimEars(kept);
  const DiskPatch* disk = grower_.cut();
  if (!disk) return {};
  const std::span<const Uv> uv = parameterizer_.solve(*disk, positions_);
  return uv.empty() ? PlanarPatch() : PlanarPatch(*disk, uv);
}

PlanarPatch PatchBuilder::aroundCell(Index cell) {
  growCore(cell);
  const std::size_t coreCount = grower_.faces().size();
  growMargin();
  return finish(grower_.faces().first(coreCount));
}

// Searches breadth first from faces[0], through faces in the ball, for faces[1] and faces[2]. The
// patch begins with the ways to them: if it grew in rings, it could close around one of them.
bool PatchBuilder::growWays(const std::array<Face, 3>& faces, const Ball& ball) {
  if (visited_.size() == 0) visited_.resize(frames_.size(), 0);
  ++visit_;
  ways_.assign(1, {faces[0], 0});
  visited_[faces[0]] = visit_;
  const auto isMet = [&](Face f) { return visited_[f] == visit_; };
  for (Index head = 0; head < ways_.size(); ++head) {
    if (isMet(faces[1]) && isMet(faces[2])) break;
    for (int i = 0; i < 3; ++i) {
      const Face g = grower_.neighbor(HalfedgeMesh::halfedge(ways_[head].face, i));
      if (!g || isMet(g)) continue;
      const bool isGoal = g == faces[1] || g == faces[2];
      if (!isGoal && !ball.holds(frames_[g].centroid)) continue;
      visited_[g] = visit_;
      ways_.push_back({g, head});
    }
  }
  visitedFaces_ += ways_.size();
  return isMet(faces[1]) && isMet(faces[2]) && addWay(faces[1]) && addWay(faces[2]);
}

// Adds the way to f face by face, from where it leaves the held faces.
bool PatchBuilder::addWay(Face f) {
  std::vector<Face> way;
  Index at = 0;
  while (ways_[at].face != f) ++at;
  for (; at != 0; at = ways_[at].from) way.push_back(ways_[at].face);
  return std::all_of(way.rbegin(), way.rend(),
                     [&](Face g) { return grower_.holds(g) || grower_.add(g); });
}

PlanarPatch PatchBuilder::aroundFaces(const std::array<Face, 3>& faces, const Ball& ball) {
  grower_.clear();
  grower_.add(faces[0]);
  if (!growWays(faces, ball)) return {};
  growOutwards([&](Face, Face g) { return ball.holds(frames_[g].centroid); });
  visitedFaces_ += grower_.faces().size();
  return finish(faces);
}

}  // namespace remesher
