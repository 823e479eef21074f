// SPDX-License-Identifier: MIT
#include "remesh/quads/map/untangle.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace remesher {

namespace {

// A triangle with less than this share of the area that it should have counts as folded: nearly
// degenerate triangles make bad quads, too.
constexpr double kLeastArea = 0.02;
// Rings around folds that move.
constexpr int kRings = 3;
// Sweeps without fewer folds, before the end.
constexpr int kIdle = 8;
// The step with the least error of a second difference: the fourth root of a double's precision
// [Press et al. 2007, 5.7].
constexpr double kDifference = 0x1p-13;

using Matrix2 = Eigen::Matrix2d;

class Untangling {
 public:
  Untangling(Eigen::VectorXd& values, const TangleInput& input) : values_(values), input_(input) {}

  std::size_t run() {
    std::vector<Face> all(input_.mesh.mesh().faceCapacity());
    for (Index f = 0; f < all.size(); ++f) all[f] = Face(f);
    std::vector<Face> folded = foldedOf(all);
    if (folded.empty()) return 0;
    const std::vector<Vertex> region = regionAround(folded);
    const std::vector<Face> faces = facesAround(region);
    std::size_t fewest = folded.size();
    int idle = 0;
    while (idle < kIdle && !folded.empty()) {
      double least = 0;
      for (const Face f : folded) least = std::min(least, jacobian(f).determinant());
      epsilon_ = std::max(1e-3, 0.5 * std::sqrt(least * least + 1e-4));
      for (const Vertex v : region) improve(v);
      folded = foldedOf(faces);
      idle = folded.size() < fewest ? 0 : idle + 1;
      fewest = std::min(fewest, folded.size());
    }
    return folded.size();
  }

 private:
  double valueOf(const IntegerSum& sum) const {
    double value = 0;
    for (const auto& [variable, coefficient] : sum) value += coefficient * values_[variable];
    return value;
  }
  Vec2 at(Halfedge corner) const {
    const auto& [u, v] = input_.system.corner(corner);
    return {valueOf(u), valueOf(v)};
  }

  // Of the map from the triangle, in sides of quads, to the plane.
  Matrix2 jacobian(Face f) const {
    const Halfedge h = HalfedgeMesh::halfedge(f);
    const Vec2 a = at(h);
    Matrix2 image, rest;
    image << at(HalfedgeMesh::next(h)) - a, at(HalfedgeMesh::prev(h)) - a;
    rest << input_.frames.edge(h), -input_.frames.edge(HalfedgeMesh::prev(h));
    return image * rest.inverse() * (input_.length * input_.sizes[f]);
  }

  std::vector<Face> foldedOf(const std::vector<Face>& faces) const {
    std::vector<Face> folded;
    for (const Face f : faces)
      if (!(jacobian(f).determinant() > kLeastArea)) folded.push_back(f);
    return folded;
  }

  std::vector<Face> facesAround(const std::vector<Vertex>& vertices) const {
    std::set<Face> faces;
    for (const Vertex v : vertices)
      input_.mesh.mesh().forEachOutgoing(v,
                                         [&](Halfedge h) { faces.insert(HalfedgeMesh::face(h)); });
    return {faces.begin(), faces.end()};
  }

  std::vector<Vertex> regionAround(const std::vector<Face>& faces) const {
    const HalfedgeMesh& m = input_.mesh.mesh();
    std::set<Vertex> region;
    for (const Face f : faces)
      for (const Vertex v : m.vertices(f)) region.insert(v);
    for (int ring = 1; ring < kRings; ++ring) {
      const std::set<Vertex> inner = region;
      for (const Vertex v : inner) m.forEachNeighbor(v, [&](Vertex w) { region.insert(w); });
    }
    return {region.begin(), region.end()};
  }

  double energy(Face f) const {
    const Matrix2 j = jacobian(f);
    const double area = j.determinant();
    const double regular = (area + std::sqrt(epsilon_ * epsilon_ + area * area)) / 2;
    return input_.frames.area(f) * (j.squaredNorm() + area * area + 1) / regular;
  }

  double energyAround(Vertex v) const {
    double sum = 0;
    input_.mesh.mesh().forEachOutgoing(v,
                                       [&](Halfedge h) { sum += energy(HalfedgeMesh::face(h)); });
    return sum;
  }

  // The real variables that place v: two inside, one on a curve, none at integer places.
  std::vector<Index> variablesOf(Vertex v) const {
    std::vector<Index> found;
    for (const IntegerSum& sum : input_.system.corner(input_.mesh.mesh().outgoing(v)))
      for (const auto& [variable, coefficient] : sum)
        if (variable < input_.system.realCount()) found.push_back(variable);
    return found;
  }

  // One step of Newton's method for each variable, by differences, halved until it helps.
  void improve(Vertex v) {
    for (const Index variable : variablesOf(v)) {
      double& x = values_[variable];
      const double before = x, here = energyAround(v);
      x = before + kDifference;
      const double ahead = energyAround(v);
      x = before - kDifference;
      const double behind = energyAround(v);
      const double slope = (ahead - behind) / (2 * kDifference);
      const double bend = (ahead - 2 * here + behind) / (kDifference * kDifference);
      double step = bend > 0 ? -slope / bend : (slope > 0 ? -0.1 : 0.1);
      step = std::clamp(step, -0.5, 0.5);
      x = before + step;
      for (; std::abs(x - before) > 0 && !(energyAround(v) < here); x = before + step) step /= 2;
    }
  }

  Eigen::VectorXd& values_;
  const TangleInput& input_;
  double epsilon_ = 1;
};

}  // namespace

std::size_t untangle(Eigen::VectorXd& values, const TangleInput& input) {
  return Untangling(values, input).run();
}

}  // namespace remesher
