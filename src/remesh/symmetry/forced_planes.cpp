// SPDX-License-Identifier: MIT
#include "remesh/symmetry/forced_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/distance_sampler.h"
#include "geometry/extent.h"
#include "remesh/symmetry/half.h"

namespace remesher {

namespace {

constexpr const char* kAxes[] = {"x", "y", "z"};

std::vector<Eigen::Index> axesOf(Symmetry symmetry) {
  switch (symmetry) {
    case Symmetry::X:
      return {0};
    case Symmetry::Y:
      return {1};
    case Symmetry::Z:
      return {2};
    case Symmetry::XY:
      return {0, 1};
    case Symmetry::XZ:
      return {0, 2};
    case Symmetry::YZ:
      return {1, 2};
    case Symmetry::XYZ:
      return {0, 1, 2};
    default:
      return {};
  }
}

// How badly planes at right angles to an axis mirror a surface.
class Mismatch {
 public:
  explicit Mismatch(const TriangleMesh& mesh) : mesh_(mesh), tree_(mesh.positions, mesh.indices) {}

  // The mean squared distance of mirrored corners to the surface.
  double operator()(const MirrorPlane& plane) const {
    constexpr std::size_t kSamples = 1000;
    const std::size_t step = mesh_.indices.size() / kSamples + 1;
    DistanceSampler sampler(tree_);
    for (std::size_t i = 0; i < mesh_.indices.size(); i += step)
      sampler.add(plane.mirrored(mesh_.positions[mesh_.indices[i]]));
    return sampler.meanSquare();
  }

 private:
  const TriangleMesh& mesh_;
  const TriangleTree tree_;
};

// Through the middle, through the origin if that is near, or between, where the match is better by
// more than rounding or noise makes.
MirrorPlane bestPlane(const TriangleMesh& mesh, Eigen::Index axis, const Mismatch& mismatch) {
  constexpr double kNear = 0.02;     // of the width
  constexpr double kBetter = 0.9;    // times as large
  constexpr double kFinest = 0.001;  // of the width
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Index v : mesh.indices) {
    low = std::min(low, mesh.positions[v][axis]);
    high = std::max(high, mesh.positions[v][axis]);
  }
  const double width = high - low, between = (low + high) / 2;
  const double middle = std::abs(between) < kSingleRoundOff * width ? 0 : between;
  MirrorPlane best{Vec3::Unit(axis), middle};
  double least = mismatch(best);
  const auto tryAt = [&](double offset, double better) {
    const MirrorPlane plane{Vec3::Unit(axis), offset};
    const double off = mismatch(plane);
    if (!(off < better * least)) return false;
    best = plane;
    least = off;
    return true;
  };
  if (std::abs(middle) <= kNear * width) tryAt(0, 1);
  for (double step = kNear * width / 2; step >= kFinest * width; step /= 2)
    for (const double sign : {-1.0, 1.0})
      if (std::abs(best.offset + sign * step - middle) <= kNear * width &&
          tryAt(best.offset + sign * step, kBetter))
        break;
  return best;
}

double areaInFront(const TriangleMesh& mesh, const MirrorPlane& plane, double slack) {
  const auto half = inFrontOf({{plane}, slack}, mesh, InPlane::LeftOut);
  return half ? extentOf(half->mesh).area : 0;
}

}  // namespace

ForcedPlanes forcedPlanes(const TriangleMesh& mesh, Symmetry symmetry) {
  constexpr double kAsMuch = 1e-6;  // of the area
  ForcedPlanes forced;
  const Mismatch mismatch(mesh);
  const double slack = kSingleRoundOff * extentOf(mesh).diagonal();
  std::string planes, sides;
  const QuarterTurn& turn = mesh.frame.turn;
  for (const Eigen::Index written : axesOf(symmetry)) {
    const Eigen::Index axis = turn.axisOf(written);
    MirrorPlane plane = bestPlane(mesh, axis, mismatch);
    const MirrorPlane behind{-plane.normal, -plane.offset};
    const double front = areaInFront(mesh, plane, slack), back = areaInFront(mesh, behind, slack);
    const bool isBehind = back > (1 + kAsMuch) * front;
    const std::string name = kAxes[written];
    const bool isSmaller = isBehind == (turn.signs[std::size_t(axis)] > 0);
    if (!planes.empty()) planes += ", ", sides += ", ";
    planes += name;
    sides += (isSmaller ? "smaller " : "larger ") + name;
    forced.planes.push_back(isBehind ? behind : plane);
  }
  forced.said = "The quads are made mirrored about planes at right angles to " + planes +
                ", from the side of " + sides + ", which has no less surface.";
  return forced;
}

}  // namespace remesher
