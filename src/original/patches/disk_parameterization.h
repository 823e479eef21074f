// SPDX-License-Identifier: MIT
// Maps a disk patch one to one onto the unit disk: the rim to the circle by arc length, each inner
// vertex to a mean of its neighbours with mean value weights [Floater, Mean value coordinates,
// 2003]. Positive weights and a strictly convex rim give a one-to-one map [Tutte 1963; Floater,
// One-to-one piecewise linear mappings, 2003]. Rounding may break this, so every result is checked
// face by face.
#pragma once

#include <span>
#include <vector>

#include "original/patches/disk_patch.h"

namespace remesher {

// Coordinates are floats: there are many patches, and all coordinates lie in the unit disk.
using Uv = Eigen::Vector2f;

// Twice the signed area of a triangle in the plane, exact to double rounding.
inline double orientation(const Uv& a, const Uv& b, const Uv& c) {
  return (double(b.x()) - a.x()) * (double(c.y()) - a.y()) -
         (double(c.x()) - a.x()) * (double(b.y()) - a.y());
}

// Maps patches one after another; keeps its memory from patch to patch.
class DiskParameterizer {
 public:
  // One point for each vertex of the patch, valid until the next call; empty if no one-to-one map
  // was found. Where mean value weights fail by rounding, equal weights are tried.
  std::span<const Uv> solve(const DiskPatch& patch, const VertexData<Vec3>& positions);

 private:
  enum class Weights { MeanValue, Equal };

  void placeRim(const DiskPatch& patch, const VertexData<Vec3>& positions);
  void gatherNeighbors(const DiskPatch& patch);
  void orderInnerVertices();
  std::size_t searchFrom(LocalIndex start, std::size_t firstRow);
  void measureBand();
  void assemble(const DiskPatch& patch, const VertexData<Vec3>& positions, Weights weights);
  void addWeight(LocalIndex from, LocalIndex to, float weight);
  void eliminate();
  void substituteBack();
  bool isOneToOne(const DiskPatch& patch) const;

  std::vector<Uv> uv_;
  std::vector<float> rimSteps_;
  // Neighbours of all vertices: those of v are neighbors_[firstNeighbor_[v] …).
  std::vector<Index> firstNeighbor_;
  std::vector<LocalIndex> neighbors_;
  // The linear system: rows are the inner vertices in breadth-first order.
  std::vector<LocalIndex> row_;         // of each vertex; kNoLocal on the rim
  std::vector<LocalIndex> vertex_;      // of each row
  std::size_t band_ = 0;                // largest distance of two neighbours' rows
  std::vector<float> matrix_;           // per row, the 2 · band_ + 1 entries about the diagonal
  std::vector<LocalIndex> lastColumn_;  // of each row, fill-in included
  std::vector<Uv> right_;
};

}  // namespace remesher
