// SPDX-License-Identifier: MIT
#include "remesh/schemes/edge_limits.h"

#include <algorithm>
#include <cmath>

#include "original/surface/size_field.h"

namespace remesher {

namespace {

// Lengths with room for what rounding moves.
WantedLimits limitsIn(const PartOptions& options, const Quantum& quantum) {
  constexpr double kRoom = 4;  // roundings of coordinates
  WantedLimits wanted;
  if (options.minEdge) wanted.shortest = *options.minEdge + kRoom * quantum.size;
  if (options.maxEdge) wanted.longest = *options.maxEdge - kRoom * quantum.size;
  if (options.minAngle) wanted.angle = radians(*options.minAngle) * (1 + kSingleRoundOff);
  return wanted;
}

}  // namespace

SizeBounds sizeBounds(const PartOptions& options) {
  const double shortest = options.minEdge.value_or(0) / kShortestOfSize;
  const double longest = options.maxEdge.value_or(kInfinity) / kLongestOfSize;
  if (shortest <= longest) return {shortest, longest};
  const double between = std::sqrt(*options.minEdge * *options.maxEdge);
  return {between, between};
}

double numberByEdges(const PartOptions& options, double area, double own) {
  const auto [shortest, longest] = sizeBounds(options);
  return options.maxEdge ? verticesForEdgeLength(area, longest)
                         : std::min(own, verticesForEdgeLength(area, shortest));
}

void keepLimits(Run& run, const PartOptions& options, Number number) {
  if (wantsOfEach(options)) keepWanted(run, limitsIn(options, run.asked.rule.quantum), number);
}

Unmet unmetLimits(const Run& run, const PartOptions& options) {
  if (!wantsOfEach(options)) return {};
  return unmetOf(run, limitsIn(options, run.asked.rule.quantum));
}

}  // namespace remesher
