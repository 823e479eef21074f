// SPDX-License-Identifier: MIT
#include "arrangement/points.h"

#include <cmath>
#include <limits>
#include <utility>

#include "geometry/predicates.h"

namespace remesher {

namespace {

constexpr double kUnit = std::numeric_limits<double>::epsilon();  // bounds a difference's error
// Bounds on the error of determinants of rounded coordinates: of the arithmetic, as a share of the
// terms' magnitudes; and of the coordinates, as a share of the largest difference (to the power of
// the dimension less one). Each is rounded up generously.
constexpr double kArithmetic3d = 8 * kUnit, kCoordinates3d = 32 * kUnit;
constexpr double kArithmetic2d = 4 * kUnit, kCoordinates2d = 8 * kUnit;
constexpr double kFar = 8;

std::array<std::uint64_t, 3> bitsOf(const Vec3& p) {
  // Adding 0 makes -0 and 0 the same.
  return {Eigen::numext::bit_cast<std::uint64_t>(p[0] + 0.0),
          Eigen::numext::bit_cast<std::uint64_t>(p[1] + 0.0),
          Eigen::numext::bit_cast<std::uint64_t>(p[2] + 0.0)};
}

int signOf(double x) { return (x > 0) - (x < 0); }

// The sign of the determinant, or 0 if rounding could have changed it.
int surelyAbove(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 u = a - p, v = b - p, w = c - p;
  const Vec3 left(v[1] * w[2], v[2] * w[0], v[0] * w[1]);
  const Vec3 right(v[2] * w[1], v[0] * w[2], v[1] * w[0]);
  const double determinant = -u.dot(left - right);
  const double magnitude = u.cwiseAbs().dot(left.cwiseAbs() + right.cwiseAbs());
  const double width =
      std::max({u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff(), w.cwiseAbs().maxCoeff()}) +
      4 * kUnit;
  const double error = kArithmetic3d * magnitude + kCoordinates3d * width * width;
  return std::abs(determinant) > error ? signOf(determinant) : 0;
}

int surelyTurns(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = a - c, v = b - c;
  const double left = u[0] * v[1], right = u[1] * v[0];
  const double width = std::max(u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff()) + kUnit;
  const double error = kArithmetic2d * (std::abs(left) + std::abs(right)) + kCoordinates2d * width;
  return std::abs(left - right) > error ? signOf(left - right) : 0;
}

Dyadic minor(const Dyadic& a, const Dyadic& b, const Dyadic& c, const Dyadic& d) {
  return a * d - b * c;
}

using Row = std::array<Dyadic, 3>;

Dyadic dot(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Row crossProduct(const Row& a, const Row& b) {
  return {minor(a[1], a[2], b[1], b[2]), minor(a[2], a[0], b[2], b[0]),
          minor(a[0], a[1], b[0], b[1])};
}

}  // namespace

std::size_t PointPool::PositionHash::operator()(const std::array<std::uint64_t, 3>& bits) const {
  std::uint64_t hash = 0;
  for (const std::uint64_t b : bits) {
    hash = (hash ^ b) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return static_cast<std::size_t>(hash);
}

PointPool::PointPool(std::span<const Vec3> given)
    : givenCount_(given.size()), positions_(given.begin(), given.end()) {
  const Vec3 origin = Vec3::Constant(-kFar);
  positions_.push_back(origin);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    positions_.push_back(origin + 4 * kFar * Vec3::Unit(axis));
}

std::array<Index, 3> PointPool::farPoints(FlatView view) const {
  const auto first = static_cast<Index>(givenCount_);
  return {first, static_cast<Index>(first + 1 + view.u()),
          static_cast<Index>(first + 1 + view.v())};
}

bool PointPool::isBefore(Index p, Index q) const {
  const Vec3 &a = positions_[p], &b = positions_[q];
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (a[axis] != b[axis]) return a[axis] < b[axis];
  return p < q;
}

void PointPool::enter(Index given) { first_.emplace(bitsOf(positions_[given]), given); }

PointPool::Exact PointPool::exact(Index point) const {
  if (!isGiven(point)) return exact_[point - givenCount_ - 4];
  const Vec3& p = positions_[point];
  return {Dyadic(p[0]), Dyadic(p[1]), Dyadic(p[2]), Dyadic(1)};
}

PointPool::Plane PointPool::planeThrough(const GivenPlane& points) const {
  const Exact a = exact(points[0]), b = exact(points[1]), c = exact(points[2]);
  const Row normal = crossProduct({b[0] - a[0], b[1] - a[1], b[2] - a[2]},
                                  {c[0] - a[0], c[1] - a[1], c[2] - a[2]});
  return {normal, dot(normal, {a[0], a[1], a[2]})};
}

bool PointPool::areEqual(const Exact& a, const Exact& b) const {
  for (std::size_t k = 0; k < 3; ++k)
    if ((a[k] * b[3] - b[k] * a[3]).sign() != 0) return false;
  return true;
}

Index PointPool::add(Exact point, const GivenLine& line) {
  if (point[3].sign() < 0)
    for (Dyadic& coordinate : point) coordinate = -coordinate;
  Vec3 position;
  for (std::size_t k = 0; k < 3; ++k)
    position[Eigen::Index(k)] = nearestQuotient(point[k], point[3]);
  const auto number = static_cast<Index>(positions_.size());
  const auto [found, isNew] = first_.emplace(bitsOf(position), number);
  for (Index other = found->second; !isNew;) {
    if (areEqual(point, exact(other))) return other;
    const auto next = next_.emplace(other, number);
    if (next.second) break;
    other = next.first->second;
  }
  positions_.push_back(position);
  exact_.push_back(std::move(point));
  lines_.push_back(line);
  return number;
}

// Where the line's ends have these signed distances, up to a common factor.
Index PointPool::onLine(const GivenLine& line, const Dyadic& fromFirst, const Dyadic& fromSecond) {
  const Exact p = exact(line[0]), q = exact(line[1]);
  Exact result;
  for (std::size_t k = 0; k < 4; ++k) result[k] = minor(p[k], q[k], fromFirst, fromSecond);
  return add(std::move(result), line);
}

Index PointPool::meet(const GivenLine& line, const GivenPlane& plane) {
  const Plane exactPlane = planeThrough(plane);
  const auto distance = [&](Index point) {
    const Exact p = exact(point);
    return dot(exactPlane.normal, {p[0], p[1], p[2]}) - exactPlane.offset;
  };
  return onLine(line, distance(line[0]), distance(line[1]));
}

Index PointPool::meet(const GivenLine& line, const GivenLine& other, FlatView view) {
  return onLine(line, exactTurn(other[0], other[1], line[0], view),
                exactTurn(other[0], other[1], line[1], view));
}

Index PointPool::meet(const GivenPlane& a, const GivenPlane& b, const GivenPlane& c) {
  const Plane p = planeThrough(a), q = planeThrough(b), r = planeThrough(c);
  const Row qr = crossProduct(q.normal, r.normal), rp = crossProduct(r.normal, p.normal),
            pq = crossProduct(p.normal, q.normal);
  Exact result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = p.offset * qr[k] + q.offset * rp[k] + r.offset * pq[k];
  result[3] = dot(p.normal, qr);
  return add(std::move(result));
}

Index PointPool::mean(const std::array<Index, 3>& points, const std::array<int, 3>& weights) {
  const Exact a = exact(points[0]), b = exact(points[1]), c = exact(points[2]);
  const Dyadic fa = Dyadic(weights[0]) * b[3] * c[3], fb = Dyadic(weights[1]) * c[3] * a[3],
               fc = Dyadic(weights[2]) * a[3] * b[3];
  Exact result;
  for (std::size_t k = 0; k < 4; ++k) result[k] = fa * a[k] + fb * b[k] + fc * c[k];
  return add(std::move(result));
}

int PointPool::above(const GivenPlane& plane, Index p) const {
  const Vec3 &a = positions_[plane[0]], &b = positions_[plane[1]], &c = positions_[plane[2]];
  if (isGiven(p)) return -orient3d(a, b, c, positions_[p]);
  if (const int sure = surelyAbove(a, b, c, positions_[p]); sure != 0) return sure;
  const Plane exactPlane = planeThrough(plane);
  const Exact q = exact(p);
  return (dot(exactPlane.normal, {q[0], q[1], q[2]}) - exactPlane.offset * q[3]).sign();
}

Dyadic PointPool::exactTurn(Index a, Index b, Index c, FlatView view) const {
  const Exact p = exact(a), q = exact(b), r = exact(c);
  const auto u = std::size_t(view.u()), v = std::size_t(view.v());
  return p[3] * minor(q[u], q[v], r[u], r[v]) + q[3] * minor(r[u], r[v], p[u], p[v]) +
         r[3] * minor(p[u], p[v], q[u], q[v]);
}

bool PointPool::isOnLine(Index p, Index a, Index b) const {
  if (isGiven(p)) return false;
  const GivenLine& line = lines_[p - givenCount_ - 4];
  return (line[0] == a && line[1] == b) || (line[0] == b && line[1] == a);
}

int PointPool::turn(Index a, Index b, Index c, FlatView view) const {
  if (a == b || b == c || c == a) return 0;
  const auto flat = [&](Index point) {
    return Vec2(positions_[point][view.u()], positions_[point][view.v()]);
  };
  if (isGiven(a) && isGiven(b) && isGiven(c)) return orient2d(flat(a), flat(b), flat(c));
  if (isOnLine(a, b, c) || isOnLine(b, c, a) || isOnLine(c, a, b)) return 0;
  if (const int sure = surelyTurns(flat(a), flat(b), flat(c)); sure != 0) return sure;
  return exactTurn(a, b, c, view).sign();
}

FlatView PointPool::viewOf(const GivenPlane& plane) const {
  const Vec3& a = positions_[plane[0]];
  const Vec3 normal = (positions_[plane[1]] - a).cross(positions_[plane[2]] - a);
  FlatView view;
  normal.cwiseAbs().maxCoeff(&view.left);
  // Rounding may have hidden which axis is best, and then one may have no area at all.
  for (int k = 0; k < 3 && turn(plane[0], plane[1], plane[2], view) == 0; ++k)
    view.left = (view.left + 1) % 3;
  return view;
}

Vec3 PointPool::barycentric(const GivenPlane& triangle, Index p) const {
  const FlatView view = viewOf(triangle);
  const Dyadic whole = exactTurn(triangle[0], triangle[1], triangle[2], view) * exact(p)[3];
  Vec3 weights;
  for (std::size_t k = 0; k < 3; ++k)
    weights[Eigen::Index(k)] =
        triangle[k] == p
            ? 1
            : nearestQuotient(exactTurn(p, triangle[(k + 1) % 3], triangle[(k + 2) % 3], view),
                              whole);
  return weights;
}

}  // namespace remesher
