// SPDX-License-Identifier: MIT
// The equations of the map from the surface to the plane whose unit squares become the quads: (u,
// v) in every triangle, such that directions 0 and 1 of the crosses run along u and v.
//
// Triangles agree at their common edge, except on the cut: across it (u, v) turns by quarter turns
// and shifts by integers, one pair for each chain of the cut [Bommes 2009]. Singular vertices and
// corners of curves have integer coordinates, and every edge of a curve lies on a line of integer u
// or v. Elimination applies all these conditions; free variables remain, some of them integers.
#pragma once

#include <Eigen/SparseCore>
#include <array>

#include "remesh/quads/map/cut.h"
#include "remesh/quads/map/integer_rows.h"

namespace remesher {

struct MapInput {
  const WorkingMesh& mesh;
  const FaceFrames& frames;
  const CutField& cut;
  const VertexData<int>& singular;
};

class SeamlessSystem {
 public:
  explicit SeamlessSystem(const MapInput& input);

  // Whether the conditions could be eliminated.
  bool isSolvable() const { return isSolvable_; }

  // Free variables: the reals first, then the integers.
  Index realCount() const { return reals_; }
  Index count() const { return count_; }

  // u and v of a corner, the origin of h in face(h), by the free variables.
  const std::array<IntegerSum, 2>& corner(Halfedge h) const { return sums_[copies_[h]]; }

  // The copies of vertices that the cut makes: of a corner, their number, and u and v of one.
  Index copy(Halfedge corner) const { return copies_[corner]; }
  Index copyCount() const { return copyCount_; }
  const std::array<IntegerSum, 2>& sumsOf(Index copy) const { return sums_[copy]; }

  // The quadratic ½ x·A·x − b·x is least where u and v follow the crosses, for quads of side 1 in
  // model units. For another side length divide b by the length. sizes: per face the side length
  // wanted there beside the others.
  struct Quadratic {
    Eigen::SparseMatrix<double> matrix;  // its lower half
    Eigen::VectorXd right;
  };
  Quadratic quadratic(const FaceData<double>& sizes) const;

 private:
  void nameCopies();
  void nameChains();
  Index freeEndOf(Halfedge h) const;
  bool addRows(IntegerRows& rows) const;
  bool addWholePlaces(IntegerRows& rows) const;
  bool addCutRows(IntegerRows& rows) const;
  bool addCurveRows(IntegerRows& rows) const;
  void numberFree(const IntegerRows& rows);

  Index variable(Halfedge corner, int axis) const { return whole_ + 2 * copies_[corner] + axis; }

  MapInput input_;
  HalfedgeData<Index> copies_;  // per corner: its copy of the vertex, which the cut may multiply
  Index copyCount_ = 0;
  std::vector<Vertex> places_;  // with integer coordinates
  HalfedgeData<Index> chains_;  // of the cut; only one halfedge of an edge has one
  Index chainCount_ = 0;
  std::vector<Halfedge> curves_;                 // halfedges on curves
  Index whole_ = 0;                              // the number of integers before elimination
  std::vector<std::array<IntegerSum, 2>> sums_;  // per copy
  Index reals_ = 0, count_ = 0;
  bool isSolvable_ = false;
};

}  // namespace remesher
