// SPDX-License-Identifier: MIT
// How large a part is shown.
#pragma once

#include <algorithm>
#include <cmath>

#include "io/model/model.h"

namespace remesher {

// The largest factor by which the part's places scale it; 1 if it is shown nowhere.
inline double shownScale(const io::Part& part) {
  double sum = 0;
  for (const Transform& place : part.instances)
    sum = std::max(sum, std::cbrt(std::abs(place.linear().determinant())));
  return sum > 0 ? sum : 1;
}

}  // namespace remesher
