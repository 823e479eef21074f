// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/fair_system.h"

#include <array>

namespace remesher {

namespace {

// Weights beside the shape of quads: of smooth rows, and of nearness to the original. More of the
// first makes rows smoother and quads farther away, more of the second makes angles worse.
constexpr double kSmoothRows = 0.005, kNear = 2;
// Of nearness, for each corner of a quad and for its middle: exact to squares.
constexpr double kCornerShare = 1.0 / 12, kMiddleShare = 2.0 / 3;
constexpr double kAtCorner = kNear * kCornerShare, kAtMiddle = kNear * kMiddleShare;

constexpr std::array<double, 5> kFourth = {1, -4, 6, -4, 1};
constexpr std::array<double, 4> kThird = {-1, 3, -3, 1};

// The residual, relative to the right side, at which the system counts as solved.
constexpr double kSolved = 1e-7;
constexpr int kMostSteps = 60;

Vec3 sumOfProducts(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].cwiseProduct(b[i]);
  return sum;
}

// 0 where the divisor is.
Vec3 quotients(const Vec3& a, const Vec3& b) {
  Vec3 result = Vec3::Zero();
  for (Eigen::Index k = 0; k < 3; ++k)
    if (b[k] > 0) result[k] = a[k] / b[k];
  return result;
}

}  // namespace

FairSystem::FairSystem(const QuadMesh& mesh, const QuadSides& sides)
    : mesh_(mesh), sides_(sides), unknown_(mesh.vertices.size(), kNone) {
  for (Index v = 0; v < unknown_.size(); ++v)
    if (mesh.vertices[v].kind == VertexKind::Interior && sides.outgoing(v) != kNone)
      unknown_[v] = count_++;
  fixed_.assign(count_, Vec3::Zero());
  std::vector<Eigen::Triplet<double>> entries;
  // Σ |corner − mean|² is Σ |corner|² − 4 |mean|².
  constexpr double kOwn = 0.75 + kAtCorner + kAtMiddle / 16, kOther = -0.25 + kAtMiddle / 16;
  for (const Four<Index>& quad : mesh.quads)
    for (const Index v : quad)
      for (const Index w : quad) addEntry(v, w, v == w ? kOwn : kOther, entries);
  addRows(entries);
  matrix_.resize(count_, count_);
  matrix_.setFromTriplets(entries.begin(), entries.end());
}

void FairSystem::addEntry(Index v, Index w, double value,
                          std::vector<Eigen::Triplet<double>>& entries) {
  if (!isFree(v)) return;
  if (!isFree(w))
    fixed_[unknown_[v]] -= value * mesh_.position(w);
  else
    entries.emplace_back(unknown_[v], unknown_[w], value);
}

void FairSystem::addTerm(std::span<const Index> vertices, std::span<const double> factors,
                         double weight, std::vector<Eigen::Triplet<double>>& entries) {
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t j = 0; j < vertices.size(); ++j)
      addEntry(vertices[i], vertices[j], weight * factors[i] * factors[j], entries);
}

// The side that goes on straight from the end of a side; kNone where rows end, at curves and at
// irregular vertices.
Index FairSystem::onward(Index side) const {
  const Index v = sides_.tip(side);
  if (!isFree(v) || sides_.isBoundary(v) || sides_.valence(v) != 4) return kNone;
  return nextSide(sides_.across(nextSide(side)));
}

// Fourth differences along the rows through each regular vertex, third ones where a row ends beside
// it: they leave alone what bends evenly, and so do not draw convex surfaces inwards.
void FairSystem::addRows(std::vector<Eigen::Triplet<double>>& entries) {
  for (Index side = 0; side < sides_.size(); ++side) {
    const Index back = sides_.across(side);
    if (back == kNone) continue;
    const Index other = onward(back);
    if (other == kNone || other < side) continue;
    const Index v = sides_.origin(side), a = sides_.tip(side), b = sides_.tip(other);
    const Index beyondA = onward(side), beyondB = onward(other);
    if (beyondA != kNone && beyondB != kNone)
      addTerm(std::array{sides_.tip(beyondB), b, v, a, sides_.tip(beyondA)}, kFourth, kSmoothRows,
              entries);
    else if (beyondA != kNone)
      addTerm(std::array{b, v, a, sides_.tip(beyondA)}, kThird, kSmoothRows, entries);
    else if (beyondB != kNone)
      addTerm(std::array{a, v, b, sides_.tip(beyondB)}, kThird, kSmoothRows, entries);
  }
}

void FairSystem::wantShape(Index quad, const Quad& rectangle) {
  const Vec3 mean = (rectangle[0] + rectangle[1] + rectangle[2] + rectangle[3]) / 4;
  for (std::size_t i = 0; i < 4; ++i) add(mesh_.quads[quad][i], rectangle[i] - mean);
}

void FairSystem::wantMiddle(Index quad, const Vec3& place) {
  for (const Index v : mesh_.quads[quad]) add(v, kAtMiddle / 4 * place);
}

void FairSystem::wantVertex(Index v, const Vec3& place) {
  add(v, kAtCorner * sides_.quadsAround(v) * place);
}

std::vector<Vec3> FairSystem::times(const std::vector<Vec3>& places) const {
  std::vector<Vec3> result(places.size(), Vec3::Zero());
  for (Index i = 0; i < count_; ++i)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix_, i); entry; ++entry)
      result[i] += entry.value() * places[std::size_t(entry.row())];
  return result;
}

// By conjugate gradients from where the vertices are, all three coordinates at once. The matrix is
// so well conditioned that a dozen steps do, each in proportion to the number of vertices.
std::vector<Vec3> FairSystem::solve() const {
  std::vector<Vec3> found(count_), places;
  for (Index v = 0; v < unknown_.size(); ++v)
    if (isFree(v)) found[unknown_[v]] = mesh_.position(v);
  std::vector<Vec3> rest = right_, way(count_, Vec3::Zero());
  const std::vector<Vec3> start = times(found);
  for (Index i = 0; i < count_; ++i) rest[i] -= start[i];
  const double enough = kSolved * kSolved * sumOfProducts(right_, right_).sum();
  Vec3 before = Vec3::Zero();
  for (int step = 0; step < kMostSteps; ++step) {
    const Vec3 now = sumOfProducts(rest, rest);
    if (!(now.sum() > enough)) break;
    const Vec3 kept = quotients(now, before);
    for (Index i = 0; i < count_; ++i) way[i] = rest[i] + kept.cwiseProduct(way[i]);
    const std::vector<Vec3> change = times(way);
    const Vec3 share = quotients(now, sumOfProducts(way, change));
    for (Index i = 0; i < count_; ++i) {
      found[i] += share.cwiseProduct(way[i]);
      rest[i] -= share.cwiseProduct(change[i]);
    }
    before = now;
  }
  for (Index v = 0; v < unknown_.size(); ++v)
    places.push_back(isFree(v) ? found[unknown_[v]] : mesh_.position(v));
  return places;
}

}  // namespace remesher
