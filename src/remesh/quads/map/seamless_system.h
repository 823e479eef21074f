// SPDX-License-Identifier: MIT
// The map of the surface to the plane whose whole coordinates become the quads: (u, v) in every
// triangle, such that directions 0 and 1 of the crosses run along u and v.
//
// Triangles agree at their common edge, but for the cut: over it (u, v) turns by quarter turns and
// moves by whole numbers, one pair for each chain of the cut [Bommes 2009]. Singular vertices and
// corners of curves have whole coordinates, and every edge of a curve lies on a line of whole u or
// v. All of this is put in by elimination, so that what is left are free variables, some whole.
#pragma once

#include <Eigen/SparseCore>
#include <array>

#include "remesh/quads/map/cut.h"
#include "remesh/quads/map/integer_rows.h"

namespace remesher {

// What the map is made of.
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

  // Free variables: the reals first, then those that are to be whole.
  Index realCount() const { return reals_; }
  Index count() const { return count_; }

  // u and v of a corner, the origin of h in face(h), by the free variables.
  const std::array<IntegerSum, 2>& corner(Halfedge h) const { return sums_[copies_[h]]; }

  // The quadratic ½ x·A·x − b·x that is least where u and v follow the crosses, a unit of length
  // being 1; for another length b is divided by it.
  struct Quadratic {
    Eigen::SparseMatrix<double> matrix;  // its lower half
    Eigen::VectorXd right;
  };
  Quadratic quadratic() const;

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
  HalfedgeData<Index> copies_;  // per corner: which of the copies that the cut makes of its vertex
  Index copyCount_ = 0;
  std::vector<Vertex> places_;  // with whole coordinates
  HalfedgeData<Index> chains_;  // of the cut, per halfedge; the other one of an edge has none
  Index chainCount_ = 0;
  std::vector<Halfedge> curves_;  // halfedges on curves
  Index whole_ = 0;               // variables before elimination that are to be whole
  std::vector<std::array<IntegerSum, 2>> sums_;  // per copy
  Index reals_ = 0, count_ = 0;
  bool isSolvable_ = false;
};

}  // namespace remesher
