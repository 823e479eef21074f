// SPDX-License-Identifier: MIT
#include "repair/findings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/mesh_triangle.h"
#include "mesh/joining.h"

namespace remesher {

namespace {

Vec3 centreOf(const TriangleMesh& mesh, Index triangle) {
  const auto [a, b, c] = cornersOf(mesh, triangle);
  return (a + b + c) / 3;
}

void sortByWidth(std::vector<SizedPlace>& places) {
  std::stable_sort(places.begin(), places.end(),
                   [](const SizedPlace& a, const SizedPlace& b) { return a.across > b.across; });
}

// The widest first, as many as a report lists.
std::vector<SizedPlace> listed(std::vector<SizedPlace> places) {
  sortByWidth(places);
  if (places.size() > kMostSizedPlaces) places.resize(kMostSizedPlaces);
  return places;
}

void warnOfWidest(RepairedMesh& result, Warning warning, std::vector<SizedPlace> places) {
  if (places.empty()) return;
  sortByWidth(places);
  warning.count = places.size();
  result.warnings.push_back({std::move(warning), places.front().at, places.front().across});
}

void warnOfSheets(RepairedMesh& result, Sheets sheets, std::size_t count) {
  if (sheets == Sheets::Drop)
    addWarning(result, {"SHEETS_DROPPED", "Sheets, which enclose nothing, were left out.", count});
  else
    addWarning(
        result,
        {"SHEETS_THICKENED",
         "Sheets, which enclose nothing, became thin solids behind their visible side.", count});
}

}  // namespace

std::vector<Vec3> centreOfFirst(const TriangleMesh& mesh, const std::vector<Index>& triangles) {
  if (triangles.empty()) return {};
  return {centreOf(mesh, triangles.front())};
}

void addWarning(RepairedMesh& result, Warning warning, const std::vector<Vec3>& places) {
  if (warning.count == 0) return;
  result.warnings.push_back({std::move(warning), std::nullopt});
  if (!places.empty()) result.warnings.back().at = places.front();
}

void warnOfCrossings(RepairedMesh& result, const std::vector<Index>& crossings) {
  result.report.selfIntersections[1] = crossings.size();
  addWarning(result, {"CROSSINGS_LEFT", "Triangles intersect others.", crossings.size()},
             centreOfFirst(result.mesh, crossings));
}

void warnOfOneSided(RepairedMesh& result, const OneSided& found) {
  addWarning(
      result,
      {"ONE_SIDED",
       "The surface has only one side, as a Möbius strip has: it has no outside, and at some "
       "edges its triangles face opposite sides. Repair leaves it as it is.",
       found.edges},
      {found.at});
}

void warnOfHidden(RepairedMesh& result, std::vector<SizedPlace> hiddenAt) {
  warnOfWidest(
      result,
      {"HIDDEN_BODIES_REMOVED", "Bodies were removed that lie inside others and are not seen."},
      std::move(hiddenAt));
}

// The report and the warnings of the exact steps.
RepairedMesh asRepaired(ExactRepair exact, const char* mode) {
  RepairedMesh result;
  result.mesh = std::move(exact.mesh);
  result.report.mode = mode;
  result.report.holes = exact.holes;
  result.report.islands = exact.islands;
  result.report.shells = exact.hiddenAt.size() + exact.filledAt.size();
  result.report.turned = exact.turned;
  result.report.lost = exact.lost;
  result.report.selfIntersections[0] = exact.crossingsBefore;
  result.report.rims = exact.rimsAt.size();
  result.report.bodies = exact.madeAt.size();
  result.report.closedAt = listed(exact.closedAt);
  result.report.rimsAt = listed(exact.rimsAt);
  warnOfWidest(
      result,
      {"RIMS_CLOSED", "Openings that look intended were closed; --keep-rims leaves them open."},
      exact.meantAt);
  warnOfWidest(result, {"RIMS_LEFT_OPEN", "Openings that look intended were left open."},
               exact.rimsAt);
  addWarning(result,
             {"HOLES_LEFT_OPEN", "Holes that are longer around than asked for were left open.",
              exact.openAt.size()},
             exact.openAt);
  addWarning(
      result,
      {"SCRAPS_REMOVED",
       "Triangles were removed: those of small open components, those that share only a vertex "
       "with the surface beside a hole, and those given twice.",
       exact.trianglesRemoved},
      exact.removedAt);
  addWarning(result, {"DEGENERATE_TRIANGLES_REMOVED",
                      "Triangles without three distinct corners were removed.", exact.lines});
  addWarning(result,
             {"BACK_TO_BACK_TRIANGLES_REMOVED",
              "Triangles back to back, which enclose nothing, were removed.", exact.backToBack});
  warnOfHidden(result, exact.hiddenAt);
  addWarning(result,
             {"CAVITIES_FILLED", "Cavities that are not seen from outside were filled.",
              exact.filledAt.size()},
             exact.filledAt);
  addWarning(result,
             {"SHEETS_LEFT",
              "Sheets such as cards, cloth or terrain enclose nothing and were left as they are; "
              "--thickness makes them bodies, --base gives a relief walls and a flat base.",
              exact.sheetsAt.size()},
             exact.sheetsAt);
  warnOfWidest(result, {"SHEETS_MADE_BODIES", "Sheets became closed bodies."}, exact.madeAt);
  addWarning(
      result,
      {"BASE_NOT_MADE",
       "Sheets whose outline folds over itself, seen along the axis that they face, got no base.",
       exact.noBaseAt.size()},
      exact.noBaseAt);
  warnOfCrossings(result, exact.crossings);
  return result;
}

RepairedMesh asRepaired(Solid solid, const TriangleMesh& input, const SolidRule& rule) {
  const InsideBy by = rule.by;
  RepairedMesh result;
  const bool isLost = std::round(100 * solid.loss.share) > 0;  // the report has two decimals
  addWarning(
      result,
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
  result.isRemade = true;
  return result;
}

}  // namespace remesher
