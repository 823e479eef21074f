// SPDX-License-Identifier: MIT
// Models of any size as models of about unit size, and back. Areas, their squares and single
// precision leave what numbers can hold long before lengths do; scaling by powers of two changes no
// digit of a coordinate.
#pragma once

#include <vector>

#include "base/options.h"
#include "io/model/model.h"

namespace remesher {

class PartScale {
 public:
  explicit PartScale(const std::vector<io::Part>& parts);

  // Whether any part, or all of them in the world, are so large or small that it matters.
  bool isNeeded() const;

  // The parts and what is asked of them, at about unit size: in local space each, and in the world.
  std::vector<io::Part> applied(std::vector<io::Part> parts) const;
  RemeshOptions applied(RemeshOptions options) const;

  // Parts that were made of applied ones, in the places and at the sizes of `originals`.
  std::vector<io::Part> undone(std::vector<io::Part> parts,
                               const std::vector<io::Part>& originals) const;

  // Where the world first shows a point of a part, of an applied one if that is needed.
  Vec3 inWorld(const io::Part& part, const Vec3& p) const;

 private:
  std::vector<double> local_;  // per part
  double world_ = 1;
};

}  // namespace remesher
