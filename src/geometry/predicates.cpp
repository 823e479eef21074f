// SPDX-License-Identifier: MIT
#include "geometry/predicates.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace remesher {

namespace {

constexpr double kHalfUlp = std::numeric_limits<double>::epsilon() / 2;
// Bound on the rounded determinant's error, as a share of the sum of its terms' magnitudes.
constexpr double kOrient2dError = (3 + 16 * kHalfUlp) * kHalfUlp;
constexpr double kOrient3dError = (7 + 56 * kHalfUlp) * kHalfUlp;

struct TwoTerms {
  double high, low;  // the rounded result and what rounding lost
};

TwoTerms exactSum(double a, double b) {
  const double sum = a + b;
  const double bRounded = sum - a, aRounded = sum - bRounded;
  return {sum, (a - aRounded) + (b - bRounded)};
}

TwoTerms halves(double a) {
  constexpr double kSplitter = 134217729;  // 2^27 + 1
  const double c = kSplitter * a;
  const double high = c - (c - a);
  return {high, a - high};
}

TwoTerms exactProduct(double a, double b) {
  const double product = a * b;
  const TwoTerms x = halves(a), y = halves(b);
  const double error = ((product - x.high * y.high) - x.low * y.high) - x.high * y.low;
  return {product, x.low * y.low - error};
}

// An exact number: a sum of terms that grow in magnitude and do not overlap; zeros are left out.
// The longest sum needed is a 3×3 determinant of differences: 192 terms.
class Expansion {
 public:
  static Expansion difference(double a, double b) {
    Expansion result;
    result.add(a);
    result.add(-b);
    return result;
  }

  void add(double term) {
    double carry = term;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < size_; ++k) {
      const TwoTerms sum = exactSum(carry, terms_[k]);
      carry = sum.high;
      if (sum.low != 0) terms_[kept++] = sum.low;
    }
    if (carry != 0) terms_[kept++] = carry;
    size_ = kept;
  }

  int sign() const { return size_ == 0 ? 0 : terms_[size_ - 1] > 0 ? 1 : -1; }

  friend Expansion operator*(const Expansion& x, const Expansion& y) {
    Expansion result;
    for (std::size_t i = 0; i < x.size_; ++i)
      for (std::size_t k = 0; k < y.size_; ++k) {
        const TwoTerms product = exactProduct(x.terms_[i], y.terms_[k]);
        result.add(product.low);
        result.add(product.high);
      }
    return result;
  }

  friend Expansion operator+(Expansion x, const Expansion& y) {
    for (std::size_t k = 0; k < y.size_; ++k) x.add(y.terms_[k]);
    return x;
  }

  friend Expansion operator-(Expansion x, const Expansion& y) {
    for (std::size_t k = 0; k < y.size_; ++k) x.add(-y.terms_[k]);
    return x;
  }

 private:
  std::array<double, 192> terms_;
  std::size_t size_ = 0;
};

int sign(double x) { return (x > 0) - (x < 0); }

int exactOrient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const auto d = [&c](const Vec2& p, Eigen::Index k) { return Expansion::difference(p[k], c[k]); };
  return (d(a, 0) * d(b, 1) - d(a, 1) * d(b, 0)).sign();
}

int exactOrient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto minor = [&](const Vec3& p, const Vec3& q) {
    const auto e = [&d](const Vec3& r, Eigen::Index k) {
      return Expansion::difference(r[k], d[k]);
    };
    return e(p, 0) * e(q, 1) - e(p, 1) * e(q, 0);
  };
  const auto height = [&d](const Vec3& p) { return Expansion::difference(p[2], d[2]); };
  return (height(a) * minor(b, c) + height(b) * minor(c, a) + height(c) * minor(a, b)).sign();
}

}  // namespace

int orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]), right = (a[1] - c[1]) * (b[0] - c[0]);
  const double determinant = left - right;
  if (std::abs(determinant) > kOrient2dError * (std::abs(left) + std::abs(right)))
    return sign(determinant);
  return exactOrient2d(a, b, c);
}

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = a - d, v = b - d, w = c - d;
  const double vw = v[0] * w[1], wv = w[0] * v[1];
  const double wu = w[0] * u[1], uw = u[0] * w[1];
  const double uv = u[0] * v[1], vu = v[0] * u[1];
  const double determinant = u[2] * (vw - wv) + v[2] * (wu - uw) + w[2] * (uv - vu);
  const double magnitude = (std::abs(vw) + std::abs(wv)) * std::abs(u[2]) +
                           (std::abs(wu) + std::abs(uw)) * std::abs(v[2]) +
                           (std::abs(uv) + std::abs(vu)) * std::abs(w[2]);
  if (std::abs(determinant) > kOrient3dError * magnitude) return sign(determinant);
  return exactOrient3d(a, b, c, d);
}

}  // namespace remesher
