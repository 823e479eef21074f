// SPDX-License-Identifier: MIT
// Shares a number of vertices among the parts of a scene by their shapes: as though all parts were
// simplified together, and of all vertices went first those that change the shape least.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/options.h"
#include "io/model/model.h"
#include "jobs/parts/part_places.h"

namespace remesher {

class ShapeShares {
 public:
  // Simplifies each part once as far as it goes.
  ShapeShares(const std::vector<io::Part>& parts, const std::vector<PartPlace>& places,
              Textures textures);

  // Per waiting part its share of so many vertices. A part gets no fewer than it can be simplified
  // to, and no more than it has.
  std::vector<double> shares(std::span<const std::size_t> waiting, double vertices) const;

 private:
  struct Part {
    double own = 0;             // its vertices
    std::vector<double> costs;  // of taking one after the other, ascending, as seen in the world
  };

  std::vector<Part> parts_;
};

}  // namespace remesher
