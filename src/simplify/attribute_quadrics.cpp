// SPDX-License-Identifier: MIT
#include "simplify/attribute_quadrics.h"

namespace remesher {

AttributeQuadrics::AttributeQuadrics(std::size_t itemSize, const std::vector<double>& values)
    : itemSize_(itemSize),
      values_(values),
      sums_(values.size() / itemSize),
      linears_(values.size()) {}

void AttributeQuadrics::addTriangle(const std::array<Vec3, 3>& corners,
                                    const std::array<Index, 3>& wedges) {
  const Vec3 b = corners[1] - corners[0], c = corners[2] - corners[0], normal = b.cross(c);
  const double square = normal.squaredNorm();
  if (!(square > 0)) return;
  const double area = normal.norm() / 2;
  const Vec3 alongB = c.cross(normal) / square, alongC = normal.cross(b) / square;
  for (const Index wedge : wedges) sums_[wedge].area += area;
  for (std::size_t k = 0; k < itemSize_; ++k) {
    const auto value = [&](int corner) { return values_[wedges[corner] * itemSize_ + k]; };
    const Vec3 gradient = (value(1) - value(0)) * alongB + (value(2) - value(0)) * alongC;
    const double offset = value(0) - gradient.dot(corners[0]);
    for (const Index wedge : wedges) {
      Quadric& functions = sums_[wedge].functions;
      functions.square += area * gradient * gradient.transpose();
      functions.linear += area * offset * gradient;
      functions.constant += area * offset * offset;
      Linear& linear = linears_[wedge * itemSize_ + k];
      linear.gradient += area * gradient;
      linear.offset += area * offset;
    }
  }
}

double AttributeQuadrics::costOf(Index wedge, Index staying, const Vec3& place) const {
  double result = sums_[wedge].functions.at(place);
  for (std::size_t k = 0; k < itemSize_; ++k) {
    const double value = values_[staying * itemSize_ + k];
    const Linear& linear = linears_[wedge * itemSize_ + k];
    result +=
        value * (sums_[wedge].area * value - 2 * (linear.gradient.dot(place) + linear.offset));
  }
  return result;
}

double AttributeQuadrics::cost(Index going, Index staying, const Vec3& place) const {
  return costOf(going, staying, place) + costOf(staying, staying, place);
}

double AttributeQuadrics::squaredJump(Index one, Index other) const {
  double result = 0;
  for (std::size_t k = 0; k < itemSize_; ++k) {
    const double step = values_[one * itemSize_ + k] - values_[other * itemSize_ + k];
    result += step * step;
  }
  return result;
}

void AttributeQuadrics::merge(Index going, Index staying) {
  sums_[staying].functions.add(sums_[going].functions);
  sums_[staying].area += sums_[going].area;
  for (std::size_t k = 0; k < itemSize_; ++k) {
    linears_[staying * itemSize_ + k].gradient += linears_[going * itemSize_ + k].gradient;
    linears_[staying * itemSize_ + k].offset += linears_[going * itemSize_ + k].offset;
  }
}

}  // namespace remesher
