// SPDX-License-Identifier: MIT
// How large a part is shown.
#pragma once

#include <algorithm>
#include <cmath>

#include "io/model/model.h"

namespace remesher {

// The largest factor by which the part's places scale it; 1 if it is shown nowhere.
inline double shownScale(const io::Part& part) {
  double largest = 0;
  for (const Transform& place : part.instances)
    largest = std::max(largest, std::cbrt(std::abs(place.linear().determinant())));
  return largest > 0 ? largest : 1;
}

}  // namespace remesher
