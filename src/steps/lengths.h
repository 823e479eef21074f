// SPDX-License-Identifier: MIT
// Edge lengths in units of the size asked for at their ends.
#pragma once

#include "steps/run.h"

namespace remesher {

// Relative lengths from which on splitting an edge, or collapsing it, brings it nearer to its
// target [Botsch & Kobbelt 2004].
inline constexpr double kLong = 4.0 / 3, kShort = 4.0 / 5;

inline double targetLength(const Run& run, Vertex a, Vertex b) {
  return 0.5 * run.scale * (run.sizes.at(run.mesh.at(a)) + run.sizes.at(run.mesh.at(b)));
}

inline double relativeLength(const Run& run, Vertex a, Vertex b) {
  return (run.mesh.position(b) - run.mesh.position(a)).norm() / targetLength(run, a, b);
}

inline double relativeLength(const Run& run, Halfedge h) {
  return relativeLength(run, run.mesh.mesh().origin(h), run.mesh.mesh().tip(h));
}

}  // namespace remesher
