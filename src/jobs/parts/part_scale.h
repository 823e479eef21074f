// SPDX-License-Identifier: MIT
// Brings models of any size and at any place to about unit size near the origin, and back. Areas,
// their squares and single precision numbers overflow or underflow long before lengths do; far from
// the origin the rounding of coordinates seems larger than it is. The factors are powers of two and
// the ways have few digits, so that no digit of a coordinate changes.
#pragma once

#include <vector>

#include "base/options.h"
#include "io/model/model.h"

namespace remesher {

class PartScale {
 public:
  explicit PartScale(const std::vector<io::Part>& parts);

  // Whether a part, or all parts in the world, are so large, so small or so far from the origin
  // that they have to be scaled or moved.
  bool isNeeded() const;

  // The parts and the options at about unit size near the origin: each part in its own space, and
  // all in the world. A part in single precision is not moved, for its coordinates are rounded
  // where they are.
  std::vector<io::Part> applied(std::vector<io::Part> parts) const;
  RemeshOptions applied(RemeshOptions options) const;

  // Parts made from applied ones, back at the sizes and places of `originals`.
  std::vector<io::Part> undone(std::vector<io::Part> parts,
                               const std::vector<io::Part>& originals) const;

  // A place on such a part.
  Vec3 undone(std::size_t part, const Vec3& p) const { return p / local_[part] + origins_[part]; }

  // Where the part's first place shows a point in the world; the part is an applied one if scaling
  // is needed.
  Vec3 inWorld(const io::Part& part, const Vec3& p) const;

 private:
  std::vector<double> local_;  // per part
  std::vector<Vec3> origins_;  // per part, what moves to the origin before it is scaled
  double world_ = 1;
  Vec3 worldOrigin_ = Vec3::Zero();
};

}  // namespace remesher
