// SPDX-License-Identifier: MIT
#include "repair/repair.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "geometry/triangle.h"
#include "measure/self_intersections.h"
#include "mesh/joining.h"
#include "repair/fineness.h"
#include "repair/holes/close_holes.h"
#include "repair/holes/plug.h"
#include "repair/holes/turn_over.h"
#include "repair/holes/used_vertices.h"
#include "repair/solid/solid.h"

namespace remesher {

namespace {

double areaOf(const TriangleMesh& mesh, std::size_t triangles) {
  double sum = 0;
  for (std::size_t i = 0; i < 3 * triangles; i += 3)
    sum += area(mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                mesh.positions[mesh.indices[i + 2]]);
  return sum;
}

Vec3 centreOf(const TriangleMesh& mesh, Index triangle) {
  const Index* v = &mesh.indices[3 * std::size_t{triangle}];
  return (mesh.positions[v[0]] + mesh.positions[v[1]] + mesh.positions[v[2]]) / 3;
}

std::vector<Vec3> firstOf(const TriangleMesh& mesh, const std::vector<Index>& triangles) {
  if (triangles.empty()) return {};
  return {centreOf(mesh, triangles.front())};
}

void warn(RepairedMesh& result, Warning warning, const std::vector<Vec3>& places = {}) {
  if (warning.count == 0) return;
  result.warnings.push_back({std::move(warning), std::nullopt});
  if (!places.empty()) result.warnings.back().at = places.front();
}

// The mesh to repair, and its self-intersecting triangles.
struct Broken {
  const TriangleMesh& mesh;
  const std::vector<Index>& crossings;
};

void countCrossings(RepairedMesh& result) {
  const std::vector<Index> crossings = selfIntersections(result.mesh);
  result.report.selfIntersections[1] = crossings.size();
  warn(result,
       {"CROSSINGS_LEFT",
        "Triangles pass through others: they did before, or what closes a hole meets the rest.",
        crossings.size()},
       firstOf(result.mesh, crossings));
}

double longestLoop(const TriangleMesh& input, const RemeshOptions& options) {
  if (!options.holesUpTo) return kInfinity;
  return *options.holesUpTo / 100 * diagonalOf(input);
}

// The enclosure on the coarsest lattice.
Enclosure roughEnclosure(const TriangleMesh& mesh) {
  RemeshOptions coarse;
  coarse.vertices = 1;
  return enclosureOf(mesh, ruleFor(mesh, coarse, InsideBy::Enclosure));
}

// The triangles kept that face the other way than given.
std::size_t countTurned(const TriangleMesh& input, const ClosedHoles& closed) {
  std::size_t turned = 0;
  for (std::size_t i = 0; i < closed.kept.size(); ++i)
    turned += closed.mesh.indices[3 * i + 1] != input.indices[3 * std::size_t{closed.kept[i]} + 1];
  return turned;
}

RepairedMesh withHolesClosed(const TriangleMesh& input, const RemeshOptions& options) {
  ClosedHoles closed = closeHoles(input, longestLoop(input, options));
  RepairedMesh result;
  result.report.mode = "holes";
  result.report.holes = closed.holes;
  result.report.islands = closed.islands;
  turnOver(closed.mesh, roughEnclosure(closed.mesh).insideOut);
  result.report.turned = countTurned(input, closed);
  const double before = areaOf(input, input.triangleCount());
  const double kept = areaOf(closed.mesh, closed.kept.size());
  result.report.lost = before > 0 ? std::max(0.0, 100 * (1 - kept / before)) : 0;
  keepUsedVertices(closed.mesh);
  result.mesh = std::move(closed.mesh);
  warn(result,
       {"HOLES_LEFT_OPEN", "Holes that are longer around than asked for were left open.",
        closed.openAt.size()},
       closed.openAt);
  warn(result, {"SCRAPS_REMOVED",
                "Triangles were removed that hang together with the surface in points only, lie "
                "loose in holes, or are given twice.",
                closed.trianglesRemoved});
  countCrossings(result);
  return result;
}

void warnOfSheets(RepairedMesh& result, Sheets sheets, std::size_t count) {
  if (sheets == Sheets::Drop)
    warn(result, {"SHEETS_DROPPED", "Sheets, which enclose nothing, were left out.", count});
  else
    warn(result,
         {"SHEETS_THICKENED",
          "Sheets, which enclose nothing, were made thin solids behind what is seen of them.",
          count});
}

RepairedMesh asRepaired(Solid solid, const TriangleMesh& input, const SolidRule& rule) {
  const InsideBy by = rule.by;
  RepairedMesh result;
  const bool isLost = std::round(100 * solid.loss.share) > 0;  // the report has two decimals
  warn(result,
       {"SEEN_PARTS_LOST",
        "Parts that are seen from outside are lost: they are too thin, or lie in gaps that close.",
        std::size_t{isLost}},
       solid.loss.places);
  warnOfSheets(result, rule.sheets, solid.enclosure.sheets);
  result.report.mode = by == InsideBy::Reach ? "wrap" : "solid";
  result.report.shells = solid.enclosure.shells;
  result.report.turned = by == InsideBy::Reach ? 0 : solid.enclosure.turned;
  result.report.lost = solid.loss.share;
  result.report.lostBeyond = 100 * solid.loss.beyond / diagonalOf(input);
  result.report.lostAt = std::move(solid.loss.places);
  result.mesh = std::move(solid.mesh);
  return result;
}

RepairedMesh wrapped(const TriangleMesh& input, const RemeshOptions& options) {
  const SolidRule rule = ruleFor(input, options, InsideBy::Reach);
  RepairedMesh result = asRepaired(solidOf(input, rule), input, rule);
  if (!result.mesh.indices.empty()) return result;
  if (rule.sheets == Sheets::Drop)
    throw Error(ErrorCode::NoTriangles, "There are only sheets, which were to be left out.",
                "Thicken them: --sheets thicken, sheets.");
  throw Error(
      ErrorCode::NoTriangles, "The triangles are too small to be wrapped.",
      "Was the mesh scaled to zero in one direction, or does it lie too far from the origin?");
}

// A surface that encloses nothing is wrapped instead.
RepairedMesh solidified(Solid solid, const TriangleMesh& input, const RemeshOptions& options) {
  if (solid.mesh.indices.empty()) return wrapped(input, options);
  return asRepaired(std::move(solid), input, ruleFor(input, options, InsideBy::Enclosure));
}

// Whether the surface that hole closing keeps intersects itself. It can only if the input does.
bool staysCrossed(const TriangleMesh& input, const std::vector<Index>& crossings) {
  constexpr double kNoLoop = -1;
  return !crossings.empty() && !selfIntersections(closeHoles(input, kNoLoop).mesh).empty();
}

// The input with holes closed; none if the result intersects itself, or if there are shells within
// bodies.
std::optional<RepairedMesh> closedSoundly(const Broken& input, const RemeshOptions& options,
                                          const Enclosure& enclosure) {
  if (!enclosure.innerAt.empty()) return std::nullopt;
  try {
    if (staysCrossed(input.mesh, input.crossings)) return std::nullopt;
    RepairedMesh closed = withHolesClosed(input.mesh, options);
    if (closed.report.selfIntersections[1] == 0) return closed;
  } catch (const Error& error) {
    if (error.code != ErrorCode::NoTriangles) throw;
  }
  return std::nullopt;
}

// Whether no shell is left within a body.
bool isEnough(const RepairedMesh& closed) {
  const bool isAsGiven = closed.report.holes == 0 && closed.warnings.empty();
  return isAsGiven || roughEnclosure(closed.mesh).innerAt.empty();
}

// Whether the surface bounds bodies: then all half lines agree at most points beside the surface,
// and hardly any visible surface is lost. Assemblies of bodies, also inside out, have 0 % unsure
// and below 1 % lost; an open sheet has 80 % and 56 %.
bool isClear(const Enclosure& enclosure) {
  constexpr double kMostUnsure = 0.1, kMostLost = 3;
  return enclosure.unsure < kMostUnsure && enclosure.lost < kMostLost && enclosure.isAny;
}

// The closed pieces as bodies, without pieces inside others, which nobody sees.
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

RepairedMesh because(const char* reason, RepairedMesh result) {
  result.report.reason = reason;
  return result;
}

RepairedMesh automatic(const Broken& broken, const RemeshOptions& options) {
  const TriangleMesh& input = broken.mesh;
  std::optional<SolidGround> ground(std::in_place, input,
                                    ruleFor(input, options, InsideBy::Enclosure));
  const Enclosure enclosure = ground->enclosure();
  if (std::optional<RepairedMesh> closed = closedSoundly(broken, options, enclosure)) {
    if (isEnough(*closed)) return because("sound", std::move(*closed));
    ground.reset();  // a solid takes as much memory again, and so does a wrap
    return because("shells", unitedOnceClosed(std::move(*closed), options));
  }
  if (isClear(enclosure)) return because("enclosed", solidified(ground->solid(), input, options));
  ground.reset();
  return because("open", wrapped(input, options));
}

RepairedMesh repaired(const Broken& broken, const RemeshOptions& options) {
  const TriangleMesh& input = broken.mesh;
  const char* const asked = "asked";
  switch (options.repair) {
    case Repair::Holes:
      return because(asked, withHolesClosed(input, options));
    case Repair::Solid:
      return because(asked, solidified(solidOf(input, ruleFor(input, options, InsideBy::Enclosure)),
                                       input, options));
    case Repair::Wrap:
      return because(asked, wrapped(input, options));
    default:
      return automatic(broken, options);
  }
}

}  // namespace

FaultReport faultsOf(const TriangleMesh& input) {
  requireValid(input);
  requireMemory(input, {});
  const Enclosure enclosure = roughEnclosure(input);
  FaultReport faults;
  // All loops of the input, also of islands and pinches, which hole closing would remove.
  const BuiltMesh built = buildMesh(input);
  const double diagonal = diagonalOf(input);
  for (const Loop& loop : boundaryLoops(built)) {
    faults.openLoops.push_back(100 * loop.length / diagonal);
    faults.places.openLoops.push_back(built.positions[loop.vertices.front()]);
  }
  const std::vector<Index> crossings = selfIntersections(input);
  faults.selfIntersections = crossings.size();
  faults.places.selfIntersections = firstOf(input, crossings);
  faults.innerShells = enclosure.innerAt.size();
  faults.places.innerShells = enclosure.innerAt;
  faults.insideOut = enclosure.insideOutAt.size();
  faults.places.insideOut = enclosure.insideOutAt;
  if (faults.openLoops.empty() && crossings.empty() && enclosure.innerAt.empty() &&
      enclosure.insideOut.empty())
    return faults;
  const std::optional<RepairedMesh> closed = closedSoundly({input, crossings}, {}, enclosure);
  RemeshOptions alone;
  alone.repair = faults.repair = closed && isEnough(*closed)    ? Repair::Holes
                                 : closed || isClear(enclosure) ? Repair::Solid
                                                                : Repair::Wrap;
  faults.needs = needsOf(input, alone);
  return faults;
}

RepairedMesh repairSurface(const TriangleMesh& input, const RemeshOptions& options) {
  requireValid(input);
  requireMemory(input, options);
  const std::vector<Index> crossings = selfIntersections(input);
  RepairedMesh result = repaired({input, crossings}, options);
  result.report.selfIntersections[0] = crossings.size();
  return result;
}

}  // namespace remesher
