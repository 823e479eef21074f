// SPDX-License-Identifier: MIT
#include "repair/repair.h"

#include <algorithm>
#include <limits>

#include "geometry/triangle.h"
#include "geometry/triangle_tree.h"
#include "measure/self_intersections.h"
#include "repair/holes/close_holes.h"

namespace remesher {

namespace {

double diagonalOf(const TriangleMesh& mesh) {
  Box box;
  for (const Index v : mesh.indices) box.extend(mesh.positions[v]);
  return (box.high - box.low).norm();
}

double areaOf(const TriangleMesh& mesh, std::size_t triangles) {
  double sum = 0;
  for (std::size_t i = 0; i < 3 * triangles; i += 3)
    sum += area(mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                mesh.positions[mesh.indices[i + 2]]);
  return sum;
}

void warn(std::vector<Warning>& warnings, const char* code, const char* message,
          std::size_t count) {
  if (count > 0) warnings.push_back({code, message, count});
}

double longestLoop(const TriangleMesh& input, const RemeshOptions& options) {
  if (!options.holesUpTo) return std::numeric_limits<double>::infinity();
  return *options.holesUpTo / 100 * diagonalOf(input);
}

RepairedMesh withHolesClosed(const TriangleMesh& input, const RemeshOptions& options) {
  ClosedHoles closed = closeHoles(input, longestLoop(input, options));
  RepairedMesh result;
  result.report.mode = "holes";
  result.report.holes = closed.holes;
  result.report.islands = closed.islands;
  result.report.turned = closed.turned;
  const double before = areaOf(input, input.triangleCount());
  const double kept = areaOf(closed.mesh, closed.mesh.triangleCount() - closed.plugTriangles);
  result.report.lost = before > 0 ? std::max(0.0, 100 * (1 - kept / before)) : 0;
  warn(result.warnings, "HOLES_LEFT_OPEN",
       "Holes that are longer around than asked for were left open.", closed.open);
  warn(result.warnings, "SCRAPS_REMOVED",
       "Triangles were removed that hang together with the surface in points only, lie loose in "
       "holes, or are given twice.",
       closed.trianglesRemoved);
  result.mesh = std::move(closed.mesh);
  return result;
}

}  // namespace

RepairedMesh repairSurface(const TriangleMesh& input, const RemeshOptions& options) {
  requireValid(input);
  RepairedMesh result = withHolesClosed(input, options);
  result.report.selfIntersections = {selfIntersections(input).size(),
                                     selfIntersections(result.mesh).size()};
  warn(result.warnings, "CROSSINGS_LEFT",
       "Triangles still pass through others, where the surface did before.",
       result.report.selfIntersections[1]);
  return result;
}

}  // namespace remesher
