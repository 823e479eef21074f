// SPDX-License-Identifier: MIT
#include "arrangement/dyadic.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace remesher {

namespace {

constexpr int kLimbBits = 32;
constexpr int kFractionBits = std::numeric_limits<double>::digits - 1;
constexpr int kLowestExponent = std::numeric_limits<double>::min_exponent - 1 - kFractionBits;
constexpr std::array kPlaces = {1.0, 0x1p-32, 0x1p-64};  // of limbs, from the highest down

// About x / w, to nearly double precision.
double roughQuotient(const Dyadic& x, const Dyadic& w) {
  const Dyadic::Rounded p = x.rounded(), q = w.rounded();
  return p.fraction == 0 ? 0 : std::ldexp(p.fraction / q.fraction, p.exponent - q.exponent);
}

}  // namespace

Dyadic Dyadic::zeros(std::size_t size, int exponent) {
  Dyadic result;
  result.size_ = static_cast<std::uint32_t>(size);
  result.exponent_ = exponent;
  if (size > kNear)
    result.far_.assign(size, 0);
  else
    std::fill_n(result.near_.begin(), size, Limb{0});
  return result;
}

// Most numbers have few limbs: copying the others would take most of the time.
void Dyadic::takeNear(const Dyadic& other) {
  size_ = other.size_, exponent_ = other.exponent_, sign_ = other.sign_;
  if (size_ <= kNear) std::copy_n(other.near_.begin(), size_, near_.begin());
}

Dyadic& Dyadic::operator=(const Dyadic& other) {
  if (this == &other) return *this;
  takeNear(other);
  if (size_ > kNear) far_ = other.far_;
  return *this;
}

Dyadic& Dyadic::operator=(Dyadic&& other) noexcept {
  takeNear(other);
  if (size_ > kNear) std::swap(far_, other.far_);
  return *this;
}

Dyadic::Dyadic(double finite) {
  if (finite == 0) return;
  const double size = std::abs(finite);
  std::uint64_t bits;
  std::memcpy(&bits, &size, sizeof bits);  // std::bit_cast is not everywhere
  constexpr std::uint64_t kOne = std::uint64_t{1} << kFractionBits;
  const int power = int(bits >> kFractionBits);  // 0 for numbers without the leading digit
  const std::uint64_t digits = bits % kOne + (power > 0 ? kOne : 0);
  const int exponent = kLowestExponent + std::max(power, 1) - 1;
  exponent_ = exponent >> 5;  // in limbs, rounded down
  const int shift = exponent - kLimbBits * exponent_;
  const std::uint64_t low = (digits & 0xffffffffu) << shift, high = (digits >> kLimbBits) << shift;
  const std::uint64_t middle = (low >> kLimbBits) + (high & 0xffffffffu);
  near_[0] = static_cast<Limb>(low);
  near_[1] = static_cast<Limb>(middle);
  near_[2] = static_cast<Limb>((high >> kLimbBits) + (middle >> kLimbBits));
  size_ = 3;
  sign_ = finite < 0 ? -1 : 1;
  trim();
}

void Dyadic::trim() {
  const Limb* const from = limbs();
  std::size_t first = 0, end = size_;
  while (end > 0 && from[end - 1] == 0) --end;
  while (first < end && from[first] == 0) ++first;
  const std::size_t size = end - first;
  if (size == size_) return;
  if (size <= kNear)
    std::copy(from + first, from + end, near_.begin());
  else
    std::copy(far_.begin() + std::ptrdiff_t(first), far_.begin() + std::ptrdiff_t(end),
              far_.begin());
  size_ = static_cast<std::uint32_t>(size);
  exponent_ += static_cast<std::int32_t>(first);
}

Dyadic::Rounded Dyadic::rounded() const {
  if (size_ == 0) return {0, 0};
  const int top = exponent_ + static_cast<int>(size_) - 1;
  double value = 0;
  for (std::size_t k = 0; k < std::min<std::size_t>(size_, kPlaces.size()); ++k)
    value += limbs()[size_ - 1 - k] * kPlaces[k];
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {sign_ * fraction, exponent + kLimbBits * top};
}

Dyadic Dyadic::operator-() const {
  Dyadic result = *this;
  result.sign_ = -sign_;
  return result;
}

Dyadic Dyadic::sum(const Dyadic& x, const Dyadic& y, int ySign) {
  if (x.size_ == 0 || y.size_ == 0) {
    Dyadic result = x.size_ == 0 ? y : x;
    if (x.size_ == 0) result.sign_ = ySign;
    return result;
  }
  const int low = std::min(x.exponent_, y.exponent_);
  const int end =
      std::max(x.exponent_ + static_cast<int>(x.size_), y.exponent_ + static_cast<int>(y.size_));
  Dyadic result = zeros(static_cast<std::size_t>(end - low) + 1, low);
  result.sign_ = x.sign_;
  Limb* const limbs = result.limbs();
  std::copy_n(x.limbs(), x.size_, limbs + (x.exponent_ - low));
  const Limb* const others = y.limbs();
  Limb* const from = limbs + (y.exponent_ - low);
  const std::int64_t factor = x.sign_ * ySign;
  std::int64_t carry = 0;
  std::uint32_t k = 0;
  for (Limb* limb = from; limb != limbs + result.size_ && (k < y.size_ || carry != 0); ++limb) {
    carry += *limb;
    if (k < y.size_) carry += factor * others[k++];
    *limb = static_cast<Limb>(carry);
    carry >>= kLimbBits;
  }
  if (carry < 0) {  // two's complement
    result.sign_ = ySign;
    std::uint64_t one = 1;
    for (k = 0; k < result.size_; ++k) {
      one += static_cast<Limb>(~limbs[k]);
      limbs[k] = static_cast<Limb>(one);
      one >>= kLimbBits;
    }
  }
  result.trim();
  return result;
}

Dyadic operator*(const Dyadic& x, const Dyadic& y) {
  Dyadic result;
  if (x.size_ == 0 || y.size_ == 0) return result;
  result = Dyadic::zeros(std::size_t{x.size_} + y.size_, x.exponent_ + y.exponent_);
  result.sign_ = x.sign_ * y.sign_;
  Dyadic::Limb* const out = result.limbs();
  const Dyadic::Limb* const left = x.limbs();
  const Dyadic::Limb* const right = y.limbs();
  for (std::size_t i = 0; i < x.size_; ++i) {
    std::uint64_t carry = 0;
    for (std::size_t k = 0; k < y.size_; ++k) {
      carry += std::uint64_t{left[i]} * right[k] + out[i + k];
      out[i + k] = static_cast<Dyadic::Limb>(carry);
      carry >>= kLimbBits;
    }
    out[i + y.size_] = static_cast<Dyadic::Limb>(carry);
  }
  result.trim();
  return result;
}

double nearestQuotient(const Dyadic& x, const Dyadic& w) {
  double q = roughQuotient(x, w);
  Dyadic rest = x - Dyadic(q) * w;
  constexpr int kRounds = 3;  // one suffices but for roundings of the last digit
  for (int round = 0; round < kRounds && rest.sign() != 0; ++round) {
    const double next = q + roughQuotient(rest, w);
    if (next == q) break;
    q = next;
    rest = x - Dyadic(q) * w;
  }
  const int direction = rest.sign() * w.sign();
  if (direction == 0) return q;
  const double beyond = std::nextafter(q, direction * std::numeric_limits<double>::infinity());
  const Dyadic pastMiddle = x + x - (Dyadic(q) + Dyadic(beyond)) * w;
  const int side = pastMiddle.sign() * w.sign();
  return side == 0 ? std::min(q, beyond) : side == direction ? beyond : q;
}

}  // namespace remesher
