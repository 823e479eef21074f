// SPDX-License-Identifier: MIT
#include "repair/repair.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
#include "geometry/triangle.h"
#include "geometry/triangle_tree.h"
#include "measure/self_intersections.h"
#include "repair/holes/close_holes.h"
#include "repair/holes/plug.h"
#include "repair/solid/solid.h"

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
  result.report.selfIntersections[1] = selfIntersections(closed.mesh).size();
  result.mesh = std::move(closed.mesh);
  return result;
}

// Half of the edges that are asked for, within what shows parts and what memory holds: 250 MB at
// 1/400 of the diagonal of a cube.
double spacingFor(const TriangleMesh& input, const RemeshOptions& options) {
  constexpr double kFinest = 400, kCoarsest = 128, kUsual = 256;
  const double diagonal = diagonalOf(input);
  double edge = 2 * diagonal / kUsual;
  if (options.vertices) {
    const double each = areaOf(input, input.triangleCount()) / double(*options.vertices);
    edge = std::sqrt(2 / std::sqrt(3.0) * each);
  }
  if (options.edgeLength) edge = *options.edgeLength;
  return std::clamp(edge / 2, diagonal / kFinest, diagonal / kCoarsest);
}

// What is remeshed to a number gets other triangles anyway.
Cleaning cleaningFor(const RemeshOptions& options) {
  const bool isRemeshed = options.vertices || options.ratio || options.edgeLength;
  return isRemeshed ? Cleaning::None : Cleaning::Thorough;
}

SolidRule ruleFor(const TriangleMesh& input, const RemeshOptions& options, InsideBy by) {
  constexpr double kUsualGap = 2;  // percent of the diagonal
  const double gap = options.gap.value_or(kUsualGap) / 100 * diagonalOf(input);
  return {spacingFor(input, options), by, by == InsideBy::Reach ? gap : 0, cleaningFor(options)};
}

RepairedMesh asRepaired(Solid solid, InsideBy by) {
  RepairedMesh result;
  result.report.mode = by == InsideBy::Reach ? "wrap" : "solid";
  result.report.shells = solid.enclosure.shells;
  result.report.turned = by == InsideBy::Reach ? 0 : solid.enclosure.turned;
  result.report.lost = solid.enclosure.lost;
  result.mesh = std::move(solid.mesh);
  return result;
}

RepairedMesh wrapped(const TriangleMesh& input, const RemeshOptions& options) {
  RepairedMesh result =
      asRepaired(solidOf(input, ruleFor(input, options, InsideBy::Reach)), InsideBy::Reach);
  if (!result.mesh.indices.empty()) return result;
  throw Error(
      ErrorCode::NoTriangles, "The triangles are too small to be wrapped.",
      "Was the mesh scaled to zero in one direction, or does it lie too far from the origin?");
}

// What encloses nothing is wrapped.
RepairedMesh solidified(Solid solid, const TriangleMesh& input, const RemeshOptions& options) {
  if (solid.mesh.indices.empty()) return wrapped(input, options);
  return asRepaired(std::move(solid), InsideBy::Enclosure);
}

// A shell within a body that is no cavity, a body inside out.
bool facesWrongWay(const Enclosure& enclosure) { return enclosure.inner + enclosure.insideOut > 0; }

// On the coarsest lattice.
Enclosure roughEnclosure(const TriangleMesh& mesh) {
  RemeshOptions coarse;
  coarse.vertices = 1;
  return enclosureOf(mesh, ruleFor(mesh, coarse, InsideBy::Enclosure));
}

// With holes closed, if nothing passes through itself then; not where a piece that is closed
// already faces the wrong way.
std::optional<RepairedMesh> closedSoundly(const TriangleMesh& input, const RemeshOptions& options,
                                          const Enclosure& enclosure) {
  if (facesWrongWay(enclosure)) return std::nullopt;
  try {
    RepairedMesh closed = withHolesClosed(input, options);
    if (closed.report.selfIntersections[1] == 0) return closed;
  } catch (const Error& error) {
    if (error.code != ErrorCode::NoTriangles) throw;
  }
  return std::nullopt;
}

// Whether no piece that was closed faces the wrong way.
bool isEnough(const RepairedMesh& closed) {
  const bool isAsGiven = closed.report.holes == 0 && closed.warnings.empty();
  return isAsGiven || !facesWrongWay(roughEnclosure(closed.mesh));
}

// Of bodies most points beside the surface are told apart by all half lines, and hardly anything
// that is seen is lost. Assemblies of bodies, also inside out, have 0 and below 1 %; an open sheet
// 80 and 56 %.
bool isClear(const Enclosure& enclosure) {
  constexpr double kMostUnsure = 0.1, kMostLost = 3;
  return enclosure.unsure < kMostUnsure && enclosure.lost < kMostLost && enclosure.isAny;
}

// The bodies that closed pieces are, without what lies within others, which nobody sees.
RepairedMesh unitedOnceClosed(RepairedMesh closed, const RemeshOptions& options) {
  RepairedMesh united =
      solidified(solidOf(closed.mesh, ruleFor(closed.mesh, options, InsideBy::Enclosure)),
                 closed.mesh, options);
  united.report.holes = closed.report.holes;
  united.report.islands = closed.report.islands;
  united.report.lost = std::max(united.report.lost, closed.report.lost);
  united.warnings.insert(united.warnings.end(), closed.warnings.begin(), closed.warnings.end());
  return united;
}

RepairedMesh automatic(const TriangleMesh& input, const RemeshOptions& options) {
  std::optional<SolidGround> ground(std::in_place, input,
                                    ruleFor(input, options, InsideBy::Enclosure));
  const Enclosure enclosure = ground->enclosure();
  if (std::optional<RepairedMesh> closed = closedSoundly(input, options, enclosure)) {
    if (isEnough(*closed)) return std::move(*closed);
    ground.reset();  // a solid takes as much memory again, and so does a wrap
    return unitedOnceClosed(std::move(*closed), options);
  }
  if (isClear(enclosure)) return solidified(ground->solid(), input, options);
  ground.reset();
  return wrapped(input, options);
}

RepairedMesh repaired(const TriangleMesh& input, const RemeshOptions& options) {
  switch (options.repair) {
    case Repair::Holes:
      return withHolesClosed(input, options);
    case Repair::Solid:
      return solidified(solidOf(input, ruleFor(input, options, InsideBy::Enclosure)), input,
                        options);
    case Repair::Wrap:
      return wrapped(input, options);
    default:
      return automatic(input, options);
  }
}

// Of loops that closing holes would find; of pieces that could be kept none is there.
std::vector<double> openLoops(const TriangleMesh& input) {
  std::vector<double> lengths;
  const double diagonal = diagonalOf(input);
  for (const Loop& loop : boundaryLoops(buildMesh(input)))
    lengths.push_back(100 * loop.length / diagonal);
  std::sort(lengths.begin(), lengths.end(), std::greater<>());
  return lengths;
}

}  // namespace

FaultReport faultsOf(const TriangleMesh& input) {
  requireValid(input);
  const Enclosure enclosure = roughEnclosure(input);
  FaultReport faults;
  faults.openLoops = openLoops(input);
  faults.selfIntersections = selfIntersections(input).size();
  faults.innerShells = enclosure.inner;
  faults.insideOut = enclosure.insideOut;
  if (faults.openLoops.empty() &&
      faults.selfIntersections + enclosure.inner + enclosure.insideOut == 0)
    return faults;
  const std::optional<RepairedMesh> closed = closedSoundly(input, {}, enclosure);
  faults.repair = closed && isEnough(*closed)    ? Repair::Holes
                  : closed || isClear(enclosure) ? Repair::Solid
                                                 : Repair::Wrap;
  return faults;
}

RepairedMesh repairSurface(const TriangleMesh& input, const RemeshOptions& options) {
  requireValid(input);
  RepairedMesh result = repaired(input, options);
  result.report.selfIntersections[0] = selfIntersections(input).size();
  warn(result.warnings, "CROSSINGS_LEFT",
       "Triangles still pass through others, where the surface did before.",
       result.report.selfIntersections[1]);
  return result;
}

}  // namespace remesher
