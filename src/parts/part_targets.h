// SPDX-License-Identifier: MIT
// What the caller asks of a whole file, as what is asked of each of its parts. Small parts of a
// large scene may need more vertices than their share: they are given them, and the larger parts
// do with fewer.
#pragma once

#include <vector>

#include "base/options.h"
#include "io/model/model.h"

namespace remesher {

class PartTargets {
 public:
  // Throws Error: INVALID_OPTION for what cannot be shared. Both arguments must outlive the object.
  PartTargets(const std::vector<io::Part>& parts, const RemeshOptions& options);

  // The numbers of the parts in the order in which they are to be remeshed: the smallest first.
  const std::vector<std::size_t>& order() const { return order_; }

  // The options of one part, asked for in this order: an absolute number of vertices is shared out
  // by area in the world, an edge length is in units of the world.
  RemeshOptions of(std::size_t part) const;

  // To be told before the next part is asked about.
  void given(std::size_t part, std::size_t vertices);

 private:
  const std::vector<io::Part>& parts_;
  const RemeshOptions& options_;
  std::vector<double> areas_;
  std::vector<std::size_t> order_;
  double areaLeft_ = 0;
  double verticesLeft_ = 0;
};

}  // namespace remesher
