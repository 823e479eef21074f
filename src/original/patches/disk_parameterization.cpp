// SPDX-License-Identifier: MIT
// The system's matrix is a weakly diagonally dominant M-matrix, so Gaussian elimination is stable
// without pivoting. Breadth-first numbering from an outermost vertex keeps its band about as narrow
// as the patch is wide, which makes the direct solution faster than sparse or iterative ones at
// the size of patches (100 to 1000 vertices).
#include "original/patches/disk_parameterization.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace remesher {
namespace {

// Half-angle tangents and lengths of nearly degenerate faces are clamped to these bounds (lengths
// relative to the face's longest side), so that no weight exceeds float's precision. No rim step is
// shorter than this share of the mean step, so that the corners of a degenerate side stay apart.
constexpr float kLeastRatio = 1e-3f;

// The row of an inner vertex the search has not reached yet.
constexpr LocalIndex kUnnumbered = kNoLocal - 1;

using Vec3f = Eigen::Vector3f;

// For each corner i, the two mean value weights of its angle: toward corner i + 1 and toward corner
// i + 2.
std::array<std::array<float, 2>, 3> cornerWeights(const std::array<Vec3f, 3>& p) {
  const std::array<Vec3f, 3> side = {p[1] - p[0], p[2] - p[1], p[0] - p[2]};  // from corner i
  std::array<float, 3> length = {side[0].norm(), side[1].norm(), side[2].norm()};
  const float longest = std::max({length[0], length[1], length[2]});
  // A face shrunk to a point has no angles: it counts as equilateral.
  if (!(longest > 0)) return {{{1, 1}, {1, 1}, {1, 1}}};
  const float doubleArea = side[0].cross(side[1]).norm();
  std::array<std::array<float, 2>, 3> weights;
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 2) % 3;
    // tan(α/2) = |a × b| / (|a||b| + a · b), with a = side i and b = minus side i + 2
    const float base = length[i] * length[k] - side[i].dot(side[k]);
    const float tangent = base > 0 ? doubleArea / base : 1 / kLeastRatio;
    const float t = std::clamp(tangent, kLeastRatio, 1 / kLeastRatio);
    weights[i] = {t / std::max(length[i], kLeastRatio * longest),
                  t / std::max(length[k], kLeastRatio * longest)};
  }
  return weights;
}

}  // namespace

void DiskParameterizer::placeRim(const DiskPatch& patch, const VertexData<Vec3>& positions) {
  const std::size_t n = patch.rim.size();
  const auto at = [&](std::size_t i) -> const Vec3& {
    return positions[patch.vertices[patch.rim[i % n]]];
  };
  rimSteps_.resize(n);
  float total = 0;
  for (std::size_t i = 0; i < n; ++i) total += rimSteps_[i] = float((at(i + 1) - at(i)).norm());
  const float shortest = total > 0 ? kLeastRatio * total / float(n) : 1;
  double around = 0;
  for (float& step : rimSteps_) around += step = std::max(step, shortest);
  double reached = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * reached / around;
    uv_[patch.rim[i]] = Uv(float(std::cos(angle)), float(std::sin(angle)));
    reached += rimSteps_[i];
  }
}

// Around an inner vertex every neighbour is the tip of exactly one side that leaves it.
void DiskParameterizer::gatherNeighbors(const DiskPatch& patch) {
  const std::size_t n = patch.vertices.size();
  firstNeighbor_.assign(n + 1, 0);
  for (const LocalFace& f : patch.faces)
    for (const LocalIndex v : f.corners) ++firstNeighbor_[v];
  Index sum = 0;
  for (Index& first : firstNeighbor_) first = sum += first;
  neighbors_.resize(sum);
  // Filling from the back leaves firstNeighbor_ at the start of each vertex's run.
  for (const LocalFace& f : patch.faces)
    for (int i = 0; i < 3; ++i) neighbors_[--firstNeighbor_[f.corners[i]]] = f.corners[(i + 1) % 3];
}

// Numbers the inner vertices connected to start by breadth-first search, from firstRow on. Returns
// the row after the last.
std::size_t DiskParameterizer::searchFrom(LocalIndex start, std::size_t firstRow) {
  std::size_t end = firstRow;
  const auto visit = [&](LocalIndex v) {
    row_[v] = LocalIndex(end);
    vertex_[end++] = v;
  };
  visit(start);
  for (std::size_t head = firstRow; head < end; ++head) {
    const LocalIndex v = vertex_[head];
    for (Index k = firstNeighbor_[v]; k < firstNeighbor_[v + 1u]; ++k)
      if (row_[neighbors_[k]] == kUnnumbered) visit(neighbors_[k]);
  }
  return end;
}

// The vertex found last lies at the far end: searching again from there makes the levels narrow.
void DiskParameterizer::orderInnerVertices() {
  std::size_t rows = 0;
  vertex_.resize(row_.size());
  for (std::size_t v = 0; v < row_.size(); ++v) {
    if (row_[v] != kUnnumbered) continue;
    const std::size_t end = searchFrom(LocalIndex(v), rows);
    const LocalIndex farthest = vertex_[end - 1];
    for (std::size_t i = rows; i < end; ++i) row_[vertex_[i]] = kUnnumbered;
    rows = searchFrom(farthest, rows);
  }
  vertex_.resize(rows);
}

void DiskParameterizer::measureBand() {
  band_ = 0;
  lastColumn_.assign(vertex_.size(), 0);
  for (std::size_t r = 0; r < vertex_.size(); ++r) {
    const LocalIndex v = vertex_[r];
    LocalIndex last = LocalIndex(r);
    for (Index k = firstNeighbor_[v]; k < firstNeighbor_[v + 1u]; ++k)
      if (row_[neighbors_[k]] != kNoLocal) last = std::max(last, row_[neighbors_[k]]);
    lastColumn_[r] = last;
    band_ = std::max(band_, last - r);
  }
}

// One row says: (Σ weights) · v − Σ weight · neighbour = 0; known neighbours go to the right side.
void DiskParameterizer::addWeight(LocalIndex from, LocalIndex to, float weight) {
  const std::size_t r = row_[from];
  float* diagonal = &matrix_[r * (2 * band_ + 1) + band_];
  *diagonal += weight;
  if (row_[to] == kNoLocal) {
    right_[r] += weight * uv_[to];
  } else {
    diagonal[std::ptrdiff_t(row_[to]) - std::ptrdiff_t(r)] -= weight;
  }
}

void DiskParameterizer::assemble(const DiskPatch& patch, const VertexData<Vec3>& positions,
                                 Weights weights) {
  matrix_.assign(vertex_.size() * (2 * band_ + 1), 0);
  right_.assign(vertex_.size(), Uv::Zero());
  const Vec3& origin = positions[patch.vertices[0]];  // preserves float's precision far from zero
  for (const LocalFace& f : patch.faces) {
    std::array<std::array<float, 2>, 3> corner = {{{1, 1}, {1, 1}, {1, 1}}};
    if (weights == Weights::MeanValue) {
      std::array<Vec3f, 3> p;
      for (int i = 0; i < 3; ++i)
        p[i] = (positions[patch.vertices[f.corners[i]]] - origin).cast<float>();
      corner = cornerWeights(p);
    }
    for (int i = 0; i < 3; ++i) {
      if (row_[f.corners[i]] == kNoLocal) continue;
      addWeight(f.corners[i], f.corners[(i + 1) % 3], corner[i][0]);
      addWeight(f.corners[i], f.corners[(i + 2) % 3], corner[i][1]);
    }
  }
}

void DiskParameterizer::eliminate() {
  const std::size_t width = 2 * band_ + 1;
  for (std::size_t k = 0; k < vertex_.size(); ++k) {
    const float* pivot = &matrix_[k * width + band_];
    const std::size_t reach = lastColumn_[k] - k;
    const float inverse = 1 / pivot[0];
    for (std::size_t r = k + 1; r <= k + reach; ++r) {
      float* entry = &matrix_[r * width + band_ - (r - k)];
      if (entry[0] == 0) continue;
      const float factor = entry[0] * inverse;
      for (std::size_t j = 1; j <= reach; ++j) entry[j] -= factor * pivot[j];
      right_[r] -= factor * right_[k];
      lastColumn_[r] = std::max(lastColumn_[r], lastColumn_[k]);
    }
  }
}

void DiskParameterizer::substituteBack() {
  const std::size_t width = 2 * band_ + 1;
  for (std::size_t k = vertex_.size(); k-- > 0;) {
    const float* diagonal = &matrix_[k * width + band_];
    Uv sum = right_[k];
    for (std::size_t j = 1; j <= lastColumn_[k] - k; ++j) sum -= diagonal[j] * right_[k + j];
    right_[k] = sum / diagonal[0];
    uv_[vertex_[k]] = right_[k];
  }
}

bool DiskParameterizer::isOneToOne(const DiskPatch& patch) const {
  return std::all_of(patch.faces.begin(), patch.faces.end(), [&](const LocalFace& f) {
    return orientation(uv_[f.corners[0]], uv_[f.corners[1]], uv_[f.corners[2]]) > 0;
  });
}

std::span<const Uv> DiskParameterizer::solve(const DiskPatch& patch,
                                             const VertexData<Vec3>& positions) {
  uv_.resize(patch.vertices.size());
  row_.assign(patch.vertices.size(), kUnnumbered);
  for (const LocalIndex v : patch.rim) row_[v] = kNoLocal;
  placeRim(patch, positions);
  gatherNeighbors(patch);
  orderInnerVertices();
  for (const Weights weights : {Weights::MeanValue, Weights::Equal}) {
    measureBand();
    assemble(patch, positions, weights);
    eliminate();
    substituteBack();
    if (isOneToOne(patch)) return uv_;
  }
  return {};
}

}  // namespace remesher
