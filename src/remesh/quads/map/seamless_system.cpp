// SPDX-License-Identifier: MIT
#include "remesh/quads/map/seamless_system.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace remesher {

namespace {

// A quarter turn k times of the pair (u, v): the axis that a coordinate comes from, and its sign.
struct Source {
  int axis, sign;
};
Source turned(int axis, int turn) {
  // (u, v) → (−v, u) → (−u, −v) → (v, −u)
  constexpr Source kSources[4][2] = {
      {{0, 1}, {1, 1}}, {{1, -1}, {0, 1}}, {{0, -1}, {1, -1}}, {{1, 1}, {0, -1}}};
  return kSources[turn][axis];
}

IntegerSum sumOf(std::initializer_list<std::pair<Index, int>> terms) {
  IntegerSum sum;
  for (const auto& term : terms) sum = plus(sum, IntegerSum{term}, 1);
  return sum;
}

double cotangent(const Vec2& a, const Vec2& b) {
  const double sine = cross(a, b), cosine = a.dot(b);
  return sine > kTie * std::abs(cosine) ? cosine / sine : 0;
}

}  // namespace

SeamlessSystem::SeamlessSystem(const MapInput& input)
    : input_(input),
      copies_(input.mesh.mesh().halfedgeCapacity(), kNone),
      chains_(input.mesh.mesh().halfedgeCapacity(), kNone) {
  const HalfedgeMesh& m = input.mesh.mesh();
  nameCopies();
  for (Index i = 0; i < m.vertexCapacity(); ++i)
    if (m.isAlive(Vertex(i)) &&
        (input.singular[Vertex(i)] != 0 || input.mesh.kind(Vertex(i)) == VertexKind::Corner))
      places_.push_back(Vertex(i));
  nameChains();
  for (Index i = 0; i < m.halfedgeCapacity(); ++i)
    if (input.mesh.isCurve(Halfedge(i))) curves_.push_back(Halfedge(i));
  whole_ = Index(2 * places_.size()) + 2 * chainCount_ + Index(curves_.size());
  IntegerRows rows(whole_ + 2 * copyCount_, whole_);
  isSolvable_ = addRows(rows);
  if (!isSolvable_) return;
  rows.resolve();
  numberFree(rows);
}

// Around each vertex a new copy begins at every edge of the cut.
void SeamlessSystem::nameCopies() {
  const HalfedgeMesh& m = input_.mesh.mesh();
  for (Index i = 0; i < m.vertexCapacity(); ++i) {
    if (!m.isAlive(Vertex(i))) continue;
    Halfedge first = m.outgoing(Vertex(i));
    m.forEachOutgoing(Vertex(i), [&](Halfedge h) {
      if (!m.isBoundary(Vertex(i)) && input_.cut.isCut[h]) first = h;
    });
    Halfedge h = first;
    do {
      if (h == first || input_.cut.isCut[h]) ++copyCount_;
      copies_[h] = copyCount_ - 1;
      h = m.twin(m.prev(h));
    } while (h && h != first);
  }
}

// The edge of the cut that goes on where h ends; kNone if the chain ends there, too.
Index SeamlessSystem::freeEndOf(Halfedge h) const {
  const HalfedgeMesh& m = input_.mesh.mesh();
  const Vertex v = m.tip(h);
  const bool isWhole = input_.singular[v] != 0 || input_.mesh.kind(v) == VertexKind::Corner;
  if (m.isBoundary(v) || isWhole) return kNone;
  Halfedge next;
  int count = 0;
  m.forEachOutgoing(v, [&](Halfedge out) {
    if (!input_.cut.isCut[out]) return;
    ++count;
    if (out != m.twin(h)) next = out;
  });
  return count == 2 ? next.index : kNone;
}

void SeamlessSystem::nameChains() {
  const HalfedgeMesh& m = input_.mesh.mesh();
  HalfedgeData<char> seen(m.halfedgeCapacity(), 0);
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    if (!input_.cut.isCut[Halfedge(i)] || seen[Halfedge(i)]) continue;
    // Back to where the chain begins, or once around; the halfedges from there on are named.
    Halfedge first = m.twin(Halfedge(i));
    for (Index next = freeEndOf(first); next != kNone && next != m.twin(Halfedge(i)).index;
         next = freeEndOf(first))
      first = Halfedge(next);
    for (Index h = m.twin(first).index; h != kNone && !seen[Halfedge(h)];
         h = freeEndOf(Halfedge(h))) {
      seen[Halfedge(h)] = seen[m.twin(Halfedge(h))] = 1;
      chains_[Halfedge(h)] = chainCount_;
    }
    ++chainCount_;
  }
}

bool SeamlessSystem::addWholePlaces(IntegerRows& rows) const {
  for (Index i = 0; i < places_.size(); ++i)
    for (int axis = 0; axis < 2; ++axis) {
      const Halfedge corner = input_.mesh.mesh().outgoing(places_[i]);
      if (!rows.add(sumOf({{2 * i + axis, -1}, {variable(corner, axis), 1}}))) return false;
    }
  return true;
}

// Equations across an edge of the cut, from face(h) to face(twin(h)), at both its ends.
bool SeamlessSystem::addCutRows(IntegerRows& rows) const {
  const HalfedgeMesh& m = input_.mesh.mesh();
  const Index firstShift = Index(2 * places_.size());
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i), twin = m.twin(h);
    if (chains_[h] == kNone) continue;
    const std::pair<Halfedge, Halfedge> ends[] = {{h, m.next(twin)}, {m.next(h), twin}};
    for (const auto& [here, there] : ends)
      for (int axis = 0; axis < 2; ++axis) {
        const auto [from, sign] = turned(axis, input_.cut.turn[h]);
        const Index shift = firstShift + 2 * chains_[h] + axis;
        if (!rows.add(
                sumOf({{variable(there, axis), 1}, {variable(here, from), -sign}, {shift, -1}})))
          return false;
      }
  }
  return true;
}

// Each edge of a curve has a line of its own; where two edges meet, their common corner equates the
// lines.
bool SeamlessSystem::addCurveRows(IntegerRows& rows) const {
  const Index first = Index(2 * places_.size()) + 2 * chainCount_;
  for (Index i = 0; i < curves_.size(); ++i) {
    const Halfedge h = curves_[i];
    const double angle = input_.frames.angle(h) - input_.cut.angle[HalfedgeMesh::face(h)];
    const bool isAlongU = std::lround(angle / (std::numbers::pi / 2)) % 2 == 0;
    for (const Halfedge end : {h, HalfedgeMesh::next(h)})
      if (!rows.add(sumOf({{first + i, -1}, {variable(end, isAlongU ? 1 : 0), 1}}))) return false;
  }
  return true;
}

bool SeamlessSystem::addRows(IntegerRows& rows) const {
  return addWholePlaces(rows) && addCutRows(rows) && addCurveRows(rows);
}

void SeamlessSystem::numberFree(const IntegerRows& rows) {
  std::vector<Index> number(whole_ + 2 * copyCount_, kNone);
  for (Index i = whole_; i < number.size(); ++i)
    if (rows.isFree(i)) number[i] = count_++;
  reals_ = count_;
  for (Index i = 0; i < whole_; ++i)
    if (rows.isFree(i)) number[i] = count_++;
  sums_.resize(copyCount_);
  for (Index copy = 0; copy < copyCount_; ++copy)
    for (Index axis = 0; axis < 2; ++axis) {
      IntegerSum sum = rows.reduced({{whole_ + 2 * copy + axis, 1}});
      for (auto& term : sum) term.first = number[term.first];
      std::sort(sum.begin(), sum.end());
      sums_[copy][axis] = std::move(sum);
    }
}

// Dirichlet's energy of the difference between the gradients of u and v and the crosses'
// directions, edge by edge with cotangents. Rows may have hundreds of integers, but at most two
// reals: the square of the integers is summed up in a dense matrix, so that entries are few.
SeamlessSystem::Quadratic SeamlessSystem::quadratic(const FaceData<double>& sizes) const {
  std::vector<Eigen::Triplet<double>> entries;
  const std::size_t integers = count_ - reals_;
  std::vector<double> ofIntegers(integers * integers);
  const auto sumOf = [&](Index a, Index b) -> double& {
    return ofIntegers[(a - reals_) * integers + b - reals_];
  };
  const auto add = [&](Index a, Index b, double value) {
    if (b < reals_)
      entries.emplace_back(a, b, value);
    else
      sumOf(a, b) += value;
  };
  Quadratic result{{}, Eigen::VectorXd::Zero(count_)};
  for (Index i = 0; i < copies_.size(); ++i) {
    const Halfedge h(i), next = HalfedgeMesh::next(h), prev = HalfedgeMesh::prev(h);
    const double weight = cotangent(input_.frames.edge(prev), -input_.frames.edge(next)) / 2;
    const double angle = input_.cut.angle[HalfedgeMesh::face(h)];
    const Vec2 along(std::cos(angle), std::sin(angle)), edge = input_.frames.edge(h);
    const double size = sizes[HalfedgeMesh::face(h)];
    const double wanted[] = {edge.dot(along) / size, cross(along, edge) / size};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const IntegerSum row = plus(corner(next)[axis], corner(h)[axis], -1);
      for (const auto& [a, x] : row) {
        result.right[a] += weight * x * wanted[axis];
        for (const auto& [b, y] : row)
          if (b <= a) add(a, b, weight * x * y);
      }
    }
  }
  for (Index i = 0; i < count_; ++i) add(i, i, kTie);
  for (Index b = reals_; b < count_; ++b)
    for (Index a = b; a < count_; ++a)
      if (double sum = sumOf(a, b); sum != 0) entries.emplace_back(a, b, sum);
  result.matrix.resize(count_, count_);
  result.matrix.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace remesher
