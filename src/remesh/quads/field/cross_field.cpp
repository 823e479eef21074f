// SPDX-License-Identifier: MIT
#include "remesh/quads/field/cross_field.h"

#include <Eigen/SparseCholesky>
#include <cmath>
#include <numbers>

#include "remesh/quads/field/curvature_directions.h"
#include "remesh/quads/field/guide_directions.h"
#include "remesh/quads/field/sectors.h"

namespace remesher {

namespace {

// Weights per triangle, relative to smoothness: of a clear direction of curvature, and of the
// triangle's last direction while it is smoothed.
constexpr double kAlign = 0.04, kCling = 0.05;
// The weight of a guide's direction on the guide.
constexpr double kLead = 4;
// Rounds of smoothing.
constexpr int kSmoothings = 20;
// The sum of the crosses of edges at 45°, up to rounding.
constexpr double kOpposed = 1e-6;

struct Wish {
  Complex cross = 0;  // of size 1
  double weight = 0;
  bool isFixed = false;
};

// The cross along two edges on curves that meet in a triangle; h leaves their corner. Their mean,
// turned by 45° where they meet at less than 45°, so that each edge follows a direction of its own:
// along the same direction the triangle would have no area in the map. At 45° both ways meet.
Complex alongTwo(const FaceFrames& frames, Halfedge h) {
  const Vec2 out = frames.edge(h), other = -frames.edge(HalfedgeMesh::prev(h));
  const Complex along = std::polar(1.0, 4 * frames.angle(h));
  const Complex sum = along + std::polar(1.0, 4 * frames.angle(HalfedgeMesh::prev(h)));
  const double size = std::abs(sum);
  if (size <= kOpposed) return along * Complex(0, -1);
  return (cross(out, other) < out.dot(other) ? -sum : sum) / size;
}

// For a triangle with edges on curves, the mean of the crosses of these edges.
Complex alongCurves(const WorkingMesh& mesh, const FaceFrames& frames, Face f) {
  Complex sum = 0, first = 0;
  Halfedge between;
  int count = 0;
  for (int corner = 0; corner < 3; ++corner) {
    const Halfedge h = HalfedgeMesh::halfedge(f, corner);
    if (!mesh.isCurve(h)) continue;
    const Complex cross = std::polar(1.0, 4 * frames.angle(h));
    if (count++ == 0) first = cross;
    sum += cross;
    if (mesh.isCurve(HalfedgeMesh::prev(h))) between = h;
  }
  if (count == 2) return alongTwo(frames, between);
  return std::abs(sum) > kOpposed ? sum / std::abs(sum) : first;
}

FaceData<Wish> makeWishes(const WorkingMesh& mesh, const FaceFrames& frames, double length,
                          std::span<const Guide> guides) {
  const FaceData<Complex> directions = curvatureDirections(mesh, frames);
  const FaceData<Complex> guided = guideCrosses(mesh, frames, guides, length);
  FaceData<Wish> wishes(directions.size());
  for (Index i = 0; i < wishes.size(); ++i) {
    const Face f(i);
    const Complex curve = alongCurves(mesh, frames, f);
    const double size = std::abs(directions[f]), lead = std::abs(guided[f]);
    if (curve != 0.0)
      wishes[f] = {curve, 1, true};
    else if (lead > 0)
      wishes[f] = {guided[f] / lead, kLead * lead, false};
    else if (size > 0)
      wishes[f] = {directions[f] * directions[f] / (size * size),
                   kAlign * std::min(1.0, size * length), false};
  }
  return wishes;
}

// One unknown of type T for each triangle that is not fixed, minimizing the sum over the edges of
// weight · |value(twin's face) − rotated value(face)|², plus the sum of wishes.
template <class T>
class DualSystem {
 public:
  DualSystem(const WorkingMesh& mesh, const FaceFrames& frames, const FaceData<Wish>& wishes)
      : mesh_(mesh), frames_(frames), wishes_(wishes), unknown_(wishes.size(), kNone) {
    for (Index i = 0; i < wishes.size(); ++i)
      if (!wishes[Face(i)].isFixed) unknown_[Face(i)] = count_++;
  }

  Index count() const { return count_; }
  Index unknown(Face f) const { return unknown_[f]; }

  // rotation(h): the factor that takes a value of face(h) to face(twin(h)).
  template <class Rotation>
  bool factor(double cling, Rotation rotation) {
    std::vector<Eigen::Triplet<T>> entries;
    std::vector<double> diagonal(count_, cling);
    const HalfedgeMesh& m = mesh_.mesh();
    for (Index i = 0; i < m.faceCapacity(); ++i) {
      const Index row = unknown_[Face(i)];
      if (row == kNone) continue;
      diagonal[row] += wishes_[Face(i)].weight;
      for (int corner = 0; corner < 3; ++corner) {
        const Halfedge h = HalfedgeMesh::halfedge(Face(i), corner), twin = m.twin(h);
        if (!twin) continue;
        const double weight = dualWeight(mesh_, frames_, h);
        diagonal[row] += weight;
        const Index column = unknown_[HalfedgeMesh::face(twin)];
        if (column != kNone && column < row)
          entries.emplace_back(row, column, -weight * rotation(twin));
      }
    }
    for (Index row = 0; row < count_; ++row) entries.emplace_back(row, row, T(diagonal[row]));
    Eigen::SparseMatrix<T> matrix(count_, count_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver_.compute(matrix);
    return solver_.info() == Eigen::Success;
  }

  Eigen::Vector<T, Eigen::Dynamic> solve(const Eigen::Vector<T, Eigen::Dynamic>& right) const {
    return solver_.solve(right);
  }

 private:
  const WorkingMesh& mesh_;
  const FaceFrames& frames_;
  const FaceData<Wish>& wishes_;
  FaceData<Index> unknown_;
  Index count_ = 0;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<T>> solver_;
};

// Calls visit(unknown of f, h) for each edge of an unknown triangle f whose other side is fixed.
template <class T, class Visit>
void forEachTie(const WorkingMesh& mesh, const DualSystem<T>& system, Visit visit) {
  for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); ++i) {
    const Halfedge h(i), twin = mesh.mesh().twin(h);
    if (!twin || system.unknown(HalfedgeMesh::face(h)) == kNone) continue;
    if (system.unknown(HalfedgeMesh::face(twin)) == kNone) visit(h);
  }
}

FaceData<Complex> smoothCrosses(const WorkingMesh& mesh, const FaceFrames& frames,
                                const FaceData<Wish>& wishes) {
  FaceData<Complex> crosses(wishes.size());
  for (Index i = 0; i < wishes.size(); ++i) crosses[Face(i)] = wishes[Face(i)].cross;
  DualSystem<Complex> system(mesh, frames, wishes);
  const auto rotation = [&](Halfedge h) { return std::polar(1.0, 4 * frames.between(h)); };
  if (system.count() == 0 || !system.factor(kCling, rotation)) return crosses;
  Eigen::VectorXcd fixed = Eigen::VectorXcd::Zero(system.count());
  for (Index i = 0; i < wishes.size(); ++i)
    if (const Index row = system.unknown(Face(i)); row != kNone)
      fixed[row] = wishes[Face(i)].weight * wishes[Face(i)].cross;
  forEachTie(mesh, system, [&](Halfedge h) {
    const Halfedge twin = mesh.mesh().twin(h);
    fixed[system.unknown(HalfedgeMesh::face(h))] +=
        dualWeight(mesh, frames, h) * rotation(twin) * wishes[HalfedgeMesh::face(twin)].cross;
  });
  for (int k = 0; k < kSmoothings; ++k) {
    Eigen::VectorXcd right = fixed;
    for (Index i = 0; i < wishes.size(); ++i)
      if (const Index row = system.unknown(Face(i)); row != kNone)
        right[row] += kCling * crosses[Face(i)];
    const Eigen::VectorXcd smooth = system.solve(right);
    for (Index i = 0; i < wishes.size(); ++i) {
      const Index row = system.unknown(Face(i));
      if (row == kNone) continue;
      const double size = std::abs(smooth[row]);
      if (size > 0) crosses[Face(i)] = smooth[row] / size;
    }
  }
  return crosses;
}

bool isBesideCurve(const WorkingMesh& mesh, Face f) {
  for (int corner = 0; corner < 3; ++corner)
    if (mesh.isCurve(HalfedgeMesh::halfedge(f, corner))) return true;
  return false;
}

}  // namespace

double CrossField::bend(const FaceFrames& frames, const HalfedgeMesh& mesh, Halfedge h) const {
  const Face f = HalfedgeMesh::face(h), g = HalfedgeMesh::face(mesh.twin(h));
  return angle[g] + turn[h] * kQuarterTurn - angle[f] - frames.between(h);
}

CrossField makeCrossField(const WorkingMesh& mesh, const FaceFrames& frames, double length,
                          const FieldWishes& wishes) {
  const FaceData<Complex> crosses =
      smoothCrosses(mesh, frames, makeWishes(mesh, frames, length, wishes.guides));
  const HalfedgeMesh& m = mesh.mesh();
  CrossField field{FaceData<double>(m.faceCapacity()), HalfedgeData<int>(m.halfedgeCapacity(), 0)};
  for (Index i = 0; i < m.faceCapacity(); ++i)
    field.angle[Face(i)] = std::arg(crosses[Face(i)]) / 4;
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i), twin = m.twin(h);
    if (!twin || twin < h) continue;
    field.turn[h] = int(std::lround(-field.bend(frames, m, h) / kQuarterTurn));
    field.turn[twin] = -field.turn[h];
  }
  turnSectors(field, mesh, frames, wishes.mirrors);
  return field;
}

// The unknowns are changes of the present angles, so that fixed ones are 0.
void smoothAngles(CrossField& field, const WorkingMesh& mesh, const FaceFrames& frames) {
  // It matters only where nothing else sets an angle.
  constexpr double kStay = 1e-3;
  const HalfedgeMesh& m = mesh.mesh();
  FaceData<Wish> wishes(m.faceCapacity());
  for (Index i = 0; i < wishes.size(); ++i) wishes[Face(i)].isFixed = isBesideCurve(mesh, Face(i));
  DualSystem<double> system(mesh, frames, wishes);
  if (system.count() == 0 || !system.factor(kStay, [](Halfedge) { return 1.0; })) return;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(system.count());
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    const Index row = system.unknown(HalfedgeMesh::face(h));
    if (row != kNone && m.twin(h))
      right[row] += dualWeight(mesh, frames, h) * field.bend(frames, m, h);
  }
  const Eigen::VectorXd change = system.solve(right);
  for (Index i = 0; i < wishes.size(); ++i)
    if (const Index row = system.unknown(Face(i)); row != kNone)
      field.angle[Face(i)] += change[row];
}

}  // namespace remesher
