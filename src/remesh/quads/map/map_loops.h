// SPDX-License-Identifier: MIT
// The loops of quads that a map makes, without its quads: the lines half way between integer lines.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "remesh/quads/map/seamless_system.h"

namespace remesher {

// Shares, but for sizes.
struct MapLoops {
  double longest = 0;       // of all loops' length, in quads
  double selfCrossing = 0;  // of the quads
  double squares = 0;       // the sum of the squares of the loops' shares
  double area = 0;          // in quads
  double boundary = 0;      // its length, in sides of quads
};

class LoopMeter {
 public:
  LoopMeter(const HalfedgeMesh& mesh, const SeamlessSystem& system, const CutField& cut);

  // places: u and v of each copy of a vertex; see SeamlessSystem.
  MapLoops measure(std::span<const std::array<double, 2>> places) const;

 private:
  class Lines;

  // An edge as a side of a triangle.
  struct Side {
    Index edge = 0;
    bool isTwin = false;    // the triangle is not the one in which points are numbered
    bool isTurned = false;  // nor are its axes
  };
  using Ends = std::array<Index, 2>;  // copies

  std::vector<std::array<Index, 3>> triangles_;  // copies
  std::vector<std::array<Side, 3>> sides_;       // from corner i on
  std::vector<Ends> edges_, boundary_;
};

}  // namespace remesher
