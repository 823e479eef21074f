// SPDX-License-Identifier: MIT
#include "original/surface/boundary_sizes.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"
#include "original/surface/boundary_places.h"

namespace remesher {

namespace {

class Chords {
 public:
  Chords(const OriginalSurface& surface, const Chain& chain, const ChordRules& rules)
      : surface_(surface), chain_(chain), rules_(rules) {}

  // The longest chord from the i-th vertex, towards the end (way = 1) or the beginning (−1).
  double reach(std::size_t i, int way) const {
    const std::size_t most = way > 0 ? chain_.vertices.size() - 1 - i : i;
    std::size_t good = 0, step = 1;
    while (good < most) {
      const std::size_t next = std::min(good + step, most);
      if (!isNear(i, way, next)) {
        if (step == 1) break;
        step = 1;
        continue;
      }
      good = next;
      step *= 2;
    }
    return length(i, way, good);
  }

 private:
  const Vec3& at(std::size_t i, int way, std::size_t steps) const {
    return surface_.positions()[chain_.vertices[way > 0 ? i + steps : i - steps]];
  }

  double length(std::size_t i, int way, std::size_t steps) const {
    return std::abs(chain_.arcs[way > 0 ? i + steps : i - steps] - chain_.arcs[i]);
  }

  // Checks only about kPlacesBetween of many vertices between.
  bool isNear(std::size_t i, int way, std::size_t steps) const {
    const Vec3 &from = at(i, way, 0), &to = at(i, way, steps);
    for (std::size_t k = 1; k < steps; k += 1 + steps / kPlacesBetween) {
      const Vec3& p = at(i, way, k);
      if ((closestPoint(p, from, to, to) - p).norm() > rules_.tolerance) return false;
    }
    return true;
  }

  const OriginalSurface& surface_;
  const Chain& chain_;
  const ChordRules& rules_;
};

}  // namespace

VertexData<double> boundarySizes(const OriginalSurface& surface, const ChordRules& rules) {
  VertexData<double> sizes;
  for (const Chain& chain : surface.curves().chains()) {
    if (!chain.boundary || chain.kept) continue;
    if (sizes.size() == 0) sizes.assign(surface.mesh().vertexCapacity(), kInfinity);
    const Chords chords(surface, chain, rules);
    for (std::size_t i = 0; i < chain.vertices.size(); ++i) {
      double& size = sizes[chain.vertices[i]];
      size = std::min(size, std::max({chords.reach(i, 1), chords.reach(i, -1), rules.shortest}));
    }
  }
  return sizes;
}

}  // namespace remesher
