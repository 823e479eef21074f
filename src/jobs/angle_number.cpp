// SPDX-License-Identifier: MIT
#include "jobs/angle_number.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/fires.h"
#include "base/place.h"
#include "jobs/fewest_vertices.h"
#include "jobs/open_number.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "remesh/schemes/shape_comparison.h"

namespace remesher {

namespace {

// The most vertices tried: as a multiple of the input's, and of small inputs.
constexpr double kMostTimes = 4, kMostOfSmall = 10'000;
// The share of the triangles that may have smaller angles.
constexpr double kFewSmall = 0.001;

bool keepsAngle(const RemeshOutcome& made) {
  return double(made.unmet.smallAngles.all) <= kFewSmall * double(made.mesh.triangleCount());
}

bool isUnseen(const TriangleMesh& input, const RemeshOutcome& made) {
  const DeviationBothWays found = measureDeviation(input, made.mesh, Maximum::Sampled);
  return std::max(found.toResult.maximum, found.toOriginal.maximum) <= kSeen * found.diagonal;
}

Warning moreForAngle(std::size_t vertices, std::size_t own) {
  return {"MORE_VERTICES_TAKEN", "No number of vertices was given: a mesh of " +
                                     std::to_string(own) + " has " + std::to_string(vertices) +
                                     " now, which the smallest angle that is wanted takes."};
}

}  // namespace

bool leadsByAngle(const RemeshOptions& options) {
  return options.minAngle && !hasNumber(options) && !asksForFewest(options) &&
         options.bodies.empty();
}

RemeshOutcome remeshToAngle(const TriangleMesh& input, Welding welding,
                            const RemeshOptions& options, const Progress& progress) {
  RemeshOptions unlimited = options;
  unlimited.minAngle.reset();
  const bool isOpen = leavesNumberOpen(unlimited);
  RemeshOutcome made = isOpen ? remeshAtOpenNumber(input, welding, unlimited, progress)
                              : remeshSurface(input, welding, options, progress);
  if (isOpen && inspectMesh(made.mesh).minAngle.worst >= *options.minAngle) return made;
  if (!isOpen && keepsAngle(made)) return made;
  const bool hasShape = isOpen && made.prefer == Prefer::Shape;
  const std::size_t own = countPlaces(input.positions);
  const double most = std::max(kMostTimes * double(own), kMostOfSmall);
  RemeshOptions numbered = options;
  numbered.tooFew = TooFew::Raise;
  for (double next = double(made.vertices); next <= most; next *= 2) {
    numbered.vertices = Index(next);
    RemeshOutcome more = remeshSurface(input, welding, numbered, progress.part(1, 1));
    if (!keepsAngle(more) || (hasShape && !isUnseen(input, more))) continue;
    if (more.vertices > own) more.warnings.push_back(moreForAngle(more.vertices, own));
    return more;
  }
  fires("angle number: no number keeps the angle");
  if (hasShape || !isOpen) return made;
  return remeshSurface(input, std::move(welding), options, progress.part(1, 1));
}

}  // namespace remesher
