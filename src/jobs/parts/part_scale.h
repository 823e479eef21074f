// SPDX-License-Identifier: MIT
// Scales models of any size to about unit size, and back. Areas, their squares and single precision
// numbers overflow or underflow long before lengths do. The factors are powers of two, which change
// no digit of a coordinate.
#pragma once

#include <vector>

#include "base/options.h"
#include "io/model/model.h"

namespace remesher {

class PartScale {
 public:
  explicit PartScale(const std::vector<io::Part>& parts);

  // Whether a part, or all parts in the world, are so large or small that scaling is needed.
  bool isNeeded() const;

  // The parts and the options at about unit size: each part in its own space, and all in the world.
  std::vector<io::Part> applied(std::vector<io::Part> parts) const;
  RemeshOptions applied(RemeshOptions options) const;

  // Parts made from applied ones, back at the sizes and places of `originals`.
  std::vector<io::Part> undone(std::vector<io::Part> parts,
                               const std::vector<io::Part>& originals) const;

  // Where the part's first place shows a point in the world; the part is an applied one if scaling
  // is needed.
  Vec3 inWorld(const io::Part& part, const Vec3& p) const;

 private:
  std::vector<double> local_;  // per part
  double world_ = 1;
};

}  // namespace remesher
