// SPDX-License-Identifier: MIT
// The linear system of fairing: where inner vertices lie so that quads are like given rectangles,
// are near given places, and lie in smooth rows, all by least squares. Other vertices stay. The
// matrix depends on the connectivity alone.
#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "geometry/quad.h"
#include "remesh/quads/mesh/quad_mesh.h"
#include "remesh/quads/mesh/quad_sides.h"

namespace remesher {

class FairSystem {
 public:
  // The mesh and its sides must outlive this.
  FairSystem(const QuadMesh& mesh, const QuadSides& sides);

  Index count() const { return count_; }
  bool isFree(Index v) const { return unknown_[v] != kNone; }

  // Begins anew, with nothing wanted.
  void clear() { right_ = fixed_; }
  // That the corners of a quad lie around their mean as those of the rectangle around theirs.
  void wantShape(Index quad, const Quad& rectangle);
  // Where the middle of a quad, and where a vertex is to be.
  void wantMiddle(Index quad, const Vec3& place);
  void wantVertex(Index v, const Vec3& place);
  // Draws a vertex, whatever else is wanted.
  void draw(Index v, const Vec3& force) { add(v, force); }

  // The places of all vertices.
  std::vector<Vec3> solve() const;

 private:
  void addRows(std::vector<Eigen::Triplet<double>>& entries);
  void addTerm(std::span<const Index> vertices, std::span<const double> factors, double weight,
               std::vector<Eigen::Triplet<double>>& entries);
  void addEntry(Index v, Index w, double value, std::vector<Eigen::Triplet<double>>& entries);
  void add(Index v, const Vec3& right) {
    if (isFree(v)) right_[unknown_[v]] += right;
  }
  Index onward(Index side) const;
  std::vector<Vec3> times(const std::vector<Vec3>& places) const;  // by the matrix

  const QuadMesh& mesh_;
  const QuadSides& sides_;
  std::vector<Index> unknown_;
  Index count_ = 0;
  std::vector<Vec3> fixed_, right_;
  Eigen::SparseMatrix<double> matrix_;  // symmetric
};

}  // namespace remesher
