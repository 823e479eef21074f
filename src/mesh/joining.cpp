// SPDX-License-Identifier: MIT
#include "mesh/joining.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/fires.h"
#include "base/place.h"
#include "mesh/welding.h"

namespace remesher {
namespace {

// The rounding error that programs leave instead of zero, as a share of the model's size: a few
// roundings in the precision they computed with.
constexpr double kSingleNoise = 0x1p-22, kDoubleNoise = 0x1p-50;

// Distances to try in turn, in percent of the diagonal: from single precision's step to a visible
// one. Only a warning names the one that joins.
constexpr std::array kPercents = {1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1.0};

// Numbers of finer cells would not be exact.
constexpr double kMostCells = 0x1p50;

// It is the same whether triangles share vertices or, as in STL, have their own.
double sizeOf(const TriangleMesh& mesh) {
  std::vector<double> sizes;
  const std::size_t step = std::max<std::size_t>(1, mesh.indices.size() / 4096);
  for (std::size_t i = 0; i < mesh.indices.size(); i += step)
    sizes.push_back(mesh.positions[mesh.indices[i]].cwiseAbs().maxCoeff());
  const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t x : cell)
      hash = (hash ^ std::uint64_t(x)) * 0x9E3779B97F4A7C15u + (hash >> 29);
    return std::size_t(hash ^ (hash >> 32));
  }
};

// The first vertices of all places found so far, in cells as wide as the joining distance.
class NearPlaces {
 public:
  NearPlaces(const std::vector<Vec3>& positions, double distance, const Vec3& low)
      : positions_(positions), distance_(distance), low_(low) {}

  // The first vertex near v. If there is none, v itself, which is then a place for later vertices.
  Index firstNear(Index v) {
    const Cell own = cellOf(positions_[v]);
    Index found = kNone;
    for (Cell cell = {own[0] - 1, 0, 0}; cell[0] <= own[0] + 1; ++cell[0])
      for (cell[1] = own[1] - 1; cell[1] <= own[1] + 1; ++cell[1])
        for (cell[2] = own[2] - 1; cell[2] <= own[2] + 1; ++cell[2])
          found = std::min(found, firstIn(cell, positions_[v]));
    if (found != kNone) return found;
    cells_[own].push_back(v);
    return v;
  }

 private:
  Cell cellOf(const Vec3& p) const {
    const Vec3 at = ((p - low_) / distance_).array().floor();
    return {std::int64_t(at.x()), std::int64_t(at.y()), std::int64_t(at.z())};
  }

  Index firstIn(const Cell& cell, const Vec3& p) const {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return kNone;
    for (const Index v : found->second)
      if ((positions_[v] - p).norm() <= distance_) return v;
    return kNone;
  }

  const std::vector<Vec3>& positions_;
  double distance_;
  Vec3 low_;
  std::unordered_map<Cell, std::vector<Index>, CellHash> cells_;
};

struct Extents {
  Vec3 low, high;
};

// The box of all corners; vertices without a triangle do not count.
Extents extentsOf(const TriangleMesh& mesh) {
  Extents box{mesh.positions[mesh.indices[0]], mesh.positions[mesh.indices[0]]};
  for (const Index v : mesh.indices) {
    box.low = box.low.cwiseMin(mesh.positions[v]);
    box.high = box.high.cwiseMax(mesh.positions[v]);
  }
  return box;
}

struct EdgeCounts {
  std::size_t shared = 0, all = 0, triangles = 0;
  double share() const { return all > 0 ? double(shared) / double(all) : 0; }
};

EdgeCounts edgesOf(const TriangleMesh& mesh) {
  const Welding welding(mesh);
  EdgeCounts edges{0, 0, welding.corners.size() / 3};
  welding.forEachEdge([&](std::span<const Index> edge) {
    ++edges.all;
    edges.shared += edge.size() > 1;
  });
  return edges;
}

}  // namespace

double noiseBeside(double size, const TriangleMesh& mesh) {
  return size * (mesh.isSingle ? kSingleNoise : kDoubleNoise);
}

void joinNoise(TriangleMesh& mesh) {
  if (mesh.indices.empty()) return;
  const double nothing = noiseBeside(sizeOf(mesh), mesh);
  bool isNoisy = false;
  std::vector<Vec3> plain = mesh.positions;
  for (Vec3& p : plain)
    for (double& c : p) {
      if (std::abs(c) > nothing || c == 0) continue;
      c = 0;
      isNoisy = true;
    }
  if (!isNoisy) return;
  const std::vector<Index> exact = weld(mesh.positions), first = weld(plain);
  std::vector<char> isTorn(plain.size(), 0), differs(plain.size(), 0);
  for (Index v = 0; v < first.size(); ++v)
    if (exact[v] != exact[first[v]]) differs[first[v]] = 1;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = mesh.indices[i + k], b = mesh.indices[i + (k + 1) % 3];
      if (first[a] == first[b] && exact[a] != exact[b]) isTorn[first[a]] = 1;
    }
  for (Index v = 0; v < first.size(); ++v)
    if (differs[first[v]] && !isTorn[first[v]]) mesh.positions[v] = plain[first[v]];
}

void unifyPlaces(std::vector<Vec3>& positions) {
  const auto isPlain = [](const Vec3& p) { return canonicalPlace(p) == p; };
  if (std::all_of(positions.begin(), positions.end(), isPlain)) return;
  const std::vector<Index> first = weld(positions);
  for (Index v = 0; v < first.size(); ++v) positions[v] = positions[first[v]];
}

void joinNear(TriangleMesh& mesh, double distance) {
  std::vector<char> isCorner(mesh.positions.size(), 0);
  for (const Index v : mesh.indices) isCorner[v] = 1;
  joinNear(mesh, distance, isCorner);
}

void joinNear(TriangleMesh& mesh, double distance, std::span<const char> isMovable) {
  if (mesh.indices.empty() || !(distance > 0)) return;
  const Extents box = extentsOf(mesh);
  const double largest = (box.high - box.low).maxCoeff();
  if (!std::isfinite(largest) || largest / distance > kMostCells) {
    fires("joining: distance too small for the extent");
    return;
  }
  NearPlaces places(mesh.positions, distance, box.low);
  std::vector<Index> first;
  for (Index v = 0; v < mesh.positions.size(); ++v)
    first.push_back(isMovable[v] ? places.firstNear(v) : v);
  for (Index v = 0; v < first.size(); ++v) mesh.positions[v] = mesh.positions[first[v]];
}

std::vector<char> openVerticesOf(const TriangleMesh& mesh, const Welding& welding) {
  std::vector<char> isOpenPlace(mesh.positions.size(), 0);
  welding.forEachEdge([&](std::span<const Index> edge) {
    if (edge.size() != 1) return;
    isOpenPlace[welding.corners[edge[0]]] = 1;
    isOpenPlace[welding.corners[nextCorner(edge[0])]] = 1;
  });
  std::vector<char> isOpen(mesh.positions.size());
  for (Index v = 0; v < isOpen.size(); ++v) isOpen[v] = isOpenPlace[welding.first[v]];
  return isOpen;
}

double diagonalOf(const TriangleMesh& mesh) {
  if (mesh.indices.empty()) return 0;
  const Extents box = extentsOf(mesh);
  return (box.high - box.low).stableNorm();
}

bool isLoose(const TriangleMesh& mesh) {
  return mesh.triangleCount() > 1 && edgesOf(mesh).shared == 0;
}

std::optional<double> percentThatJoins(const TriangleMesh& mesh) {
  const double diagonal = diagonalOf(mesh);
  EdgeCounts before;
  std::optional<double> best;
  for (const double percent : kPercents) {
    TriangleMesh joined{mesh.positions, mesh.indices, {}, {}};
    joinNear(joined, percent / 100 * diagonal);
    const EdgeCounts edges = edgesOf(joined);
    if (best && (edges.triangles < before.triangles || edges.share() <= before.share())) break;
    if (2 * edges.shared >= edges.all && edges.all > 0) best = percent;
    before = edges;
  }
  return best;
}

}  // namespace remesher
