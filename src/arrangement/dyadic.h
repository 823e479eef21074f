// SPDX-License-Identifier: MIT
// Exact numbers: integers times powers of two. Every double is one, and so are sums, differences
// and products of them; homogeneous coordinates make division unnecessary.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace remesher {

class Dyadic {
 public:
  Dyadic() = default;  // 0
  Dyadic(const Dyadic& other) : Dyadic() { *this = other; }
  Dyadic(Dyadic&& other) noexcept : Dyadic() { *this = std::move(other); }
  Dyadic& operator=(const Dyadic& other);
  Dyadic& operator=(Dyadic&& other) noexcept;
  ~Dyadic() = default;
  explicit Dyadic(double finite);  // its exact value

  int sign() const { return size_ == 0 ? 0 : sign_; }

  // About the number: fraction · 2^exponent, where 1/2 <= |fraction| <= 1 unless it is 0. The
  // fraction's relative error is at most 2^-52.
  struct Rounded {
    double fraction;
    int exponent;
  };
  Rounded rounded() const;

  Dyadic operator-() const;
  friend Dyadic operator+(const Dyadic& x, const Dyadic& y) { return sum(x, y, y.sign_); }
  friend Dyadic operator-(const Dyadic& x, const Dyadic& y) { return sum(x, y, -y.sign_); }
  friend Dyadic operator*(const Dyadic& x, const Dyadic& y);

 private:
  using Limb = std::uint32_t;
  static constexpr std::size_t kNear = 24;  // limbs held without an allocation

  void takeNear(const Dyadic& other);
  static Dyadic sum(const Dyadic& x, const Dyadic& y, int ySign);
  static Dyadic zeros(std::size_t size, int exponent);
  Limb* limbs() { return size_ <= kNear ? near_.data() : far_.data(); }
  const Limb* limbs() const { return size_ <= kNear ? near_.data() : far_.data(); }
  void trim();  // takes off limbs that are zero at both ends

  // The magnitude is the sum of limb k times 2^(32 (exponent + k)).
  std::uint32_t size_ = 0;
  std::int32_t exponent_ = 0;
  std::int32_t sign_ = 1;
  std::array<Limb, kNear> near_;  // only the first size_ are set
  std::vector<Limb> far_;         // holds the limbs if there are more than kNear
};

// The double nearest to x / w; of two equally near ones the lower. It depends only on the quotient,
// not on x and w. w must not be 0, and the quotient neither overflow nor underflow.
double nearestQuotient(const Dyadic& x, const Dyadic& w);

}  // namespace remesher
