// SPDX-License-Identifier: MIT
// Edge lengths in units of the size asked for at their ends.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// The target length of an edge between places of sizes a and b.
inline double targetLength(const Run& run, double a, double b) {
  return 0.5 * run.asked.scale * (a + b);
}

inline double targetLength(const Run& run, Vertex a, Vertex b) {
  return targetLength(run, run.sizes.at(run.mesh.at(a)), run.sizes.at(run.mesh.at(b)));
}

inline double relativeLength(const Run& run, Vertex a, Vertex b) {
  return (run.mesh.position(b) - run.mesh.position(a)).norm() / targetLength(run, a, b);
}

inline double relativeLength(const Run& run, Halfedge h) {
  return relativeLength(run, run.mesh.mesh().origin(h), run.mesh.mesh().tip(h));
}

// The sizes at vertices, each computed when first asked for. The vertices must not move meanwhile.
class VertexSizes {
 public:
  explicit VertexSizes(const Run& run)
      : run_(run), sizes_(run.mesh.mesh().vertexCapacity(), kUnknown) {}

  double at(Vertex v) {
    if (v.index >= sizes_.size()) sizes_.resize(run_.mesh.mesh().vertexCapacity(), kUnknown);
    double& size = sizes_[v];
    if (size == kUnknown) size = run_.sizes.at(run_.mesh.at(v));
    return size;
  }

  double relativeLength(Vertex a, Vertex b) {
    const double length = (run_.mesh.position(b) - run_.mesh.position(a)).norm();
    return length / targetLength(run_, at(a), at(b));
  }

  double relativeLength(Halfedge h) {
    return relativeLength(run_.mesh.mesh().origin(h), run_.mesh.mesh().tip(h));
  }

 private:
  static constexpr double kUnknown = 0;  // no size is

  const Run& run_;
  VertexData<double> sizes_;
};

}  // namespace remesher
