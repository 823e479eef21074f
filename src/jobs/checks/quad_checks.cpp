// SPDX-License-Identifier: MIT
#include "jobs/checks/quad_checks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/legible.h"
#include "geometry/extent.h"
#include "geometry/quad_facing.h"
#include "geometry/triangle_tree.h"
#include "io/model/faces.h"
#include "jobs/checks/result_check.h"
#include "jobs/parts/part_places.h"
#include "mesh/welding.h"

namespace remesher {

namespace {

// A border farther off than this share of the diagonal shows.
constexpr double kOffBorder = 5e-4;

// Quads that are farther away than so many of their mean sides have lost a part of the shape.
constexpr double kLostSides = 0.6;

// The open edges of a mesh, as triangles without area, and the number of loops that they make.
struct Border {
  std::vector<Index> lines;
  std::size_t loops = 0;
};

Border borderOf(const TriangleMesh& mesh) {
  Border border;
  const Welding welding(mesh);
  DisjointSets pieces(mesh.positions.size());
  std::vector<char> isOn(mesh.positions.size(), 0);
  welding.forEachEdge([&](std::span<const Index> edge) {
    if (edge.size() != 1) return;
    const Index a = welding.corners[edge[0]], b = welding.corners[nextCorner(edge[0])];
    border.lines.insert(border.lines.end(), {a, b, b});
    for (const Index v : {a, b}) border.loops += std::exchange(isOn[v], 1) == 0;
    border.loops -= pieces.unite(a, b);
  });
  return border;
}

// The faults of one part.
struct OffBorder {
  std::size_t corners = 0, closed = 0;
  std::optional<Vec3> first;
};

OffBorder offBorder(const TriangleMesh& given, const TriangleMesh& result) {
  OffBorder off;
  const Border before = borderOf(given), after = borderOf(result);
  if (before.lines.empty()) return off;
  off.closed = before.loops - std::min(before.loops, after.loops);
  const double unit = checkedUnit(given), most = kOffBorder * unit * extentOf(given).diagonal();
  const std::vector<Vec3> positions = inUnits(given.positions, unit);
  const TriangleTree tree(positions, before.lines);
  std::vector<Index> corners = after.lines;
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  for (const Index v : corners) {
    const Vec3& p = result.positions[v];
    if (tree.nearest(unit * p).squaredDistance <= most * most) continue;
    ++off.corners;
    if (!off.first) off.first = p;
  }
  if (off.closed > 0 && !off.first) off.first = given.positions[before.lines.front()];
  return off;
}

}  // namespace

std::vector<Warning> bordersOffGiven(const std::vector<io::Part>& given,
                                     const std::vector<io::Part>& result) {
  OffBorder all;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!result[i].mesh.isQuads) continue;
    const OffBorder off = offBorder(given[i].mesh, result[i].mesh);
    all.corners += off.corners;
    all.closed += off.closed;
    if (!all.first && off.first) all.first = inWorldOf(given[i], *off.first);
  }
  if (!all.first) return {};
  std::string text;
  if (all.corners > 0)
    text = std::to_string(all.corners) + " open corners of the quads are not on the border given";
  if (all.closed > 0)
    text += (text.empty() ? "" : ", and ") + std::to_string(all.closed) +
            " of its open loops are closed";
  text.append(", the first near (").append(placeInWords(*all.first, result)).append(").");
  return {{"QUADS_OFF_BORDER", text, all.corners + all.closed, all.first}};
}

std::vector<Warning> lostToQuads(const std::vector<io::Part>& given,
                                 const std::vector<io::Part>& result) {
  double farthest = kLostSides, percent = 0;
  std::optional<Vec3> where;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const TriangleMesh& from = given[i].mesh;
    if (!result[i].mesh.isQuads || result[i].mesh.indices.empty()) continue;
    const double unit = checkedUnit(from);
    TriangleMesh quads = result[i].mesh;
    quads.positions = inUnits(std::move(quads.positions), unit);
    const double side = std::sqrt(extentOf(quads).area / (double(quads.triangleCount()) / 2));
    const FarthestCorner found = farthestCorner(from, result[i].mesh);
    const double distance = found.distance * unit;
    if (!(distance > farthest * side)) continue;
    farthest = distance / side;
    percent = 100 * found.distance / extentOf(from).diagonal();
    where = inWorldOf(given[i], found.at);
  }
  if (!where) return {};
  std::string text = "Part of the shape is lost: near (" + placeInWords(*where, given);
  text.append(") the original is ").append(inDigits(percent, 2));
  text.append(" % of the diagonal away from the quads, more than half their width. ");
  text.append("Ask for more quads.");
  return {{"QUADS_TOO_FEW", text, 1, where}};
}

std::vector<Warning> turnedFromGiven(const std::vector<io::Part>& given,
                                     const std::vector<io::Part>& result) {
  std::size_t count = 0;
  std::optional<Vec3> first;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const TriangleMesh &from = given[i].mesh, &mesh = result[i].mesh;
    if (!mesh.isQuads || mesh.indices.empty()) continue;
    const double unit = checkedUnit(from);
    const std::vector<Vec3> positions = inUnits(from.positions, unit);
    const TriangleTree tree(positions, from.indices);
    const QuadFacing facing(tree);
    const io::Faces faces(mesh);
    for (std::size_t q = 0; q < faces.count(); ++q) {
      Quad corners;
      for (std::size_t k = 0; k < 4; ++k)
        corners[k] = unit * mesh.positions[mesh.indices[faces.place(q, k)]];
      if (!facing.isAway(corners)) continue;
      ++count;
      const Vec3 middle = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
      if (!first) first = inWorldOf(result[i], middle / unit);
    }
  }
  if (!first) return {};
  std::string text = std::to_string(count) + (count == 1 ? " quad faces" : " quads face") +
                     " away from the original, the first near (";
  text.append(placeInWords(*first, result)).append(").");
  return {{"QUADS_TURNED_AWAY", text, count, first}};
}

std::vector<Warning> pairedParts(const QuadReport& quads, const std::vector<io::Part>& result) {
  if (quads.paired.empty()) return {};
  const auto largest =
      std::max_element(quads.paired.begin(), quads.paired.end(),
                       [](const PairedPart& a, const PairedPart& b) { return a.quads < b.quads; });
  std::string text = "No map to squares was found for " + std::to_string(quads.paired.size()) +
                     " of " + std::to_string(quads.parts) +
                     " connected parts: their quads are pairs of triangles, divided, with more "
                     "irregular vertices. The largest has " +
                     std::to_string(largest->quads) + " quads, near (";
  text.append(placeInWords(largest->at, result)).append(").");
  return {{"QUADS_PAIRED", text, quads.paired.size(), largest->at}};
}

}  // namespace remesher
