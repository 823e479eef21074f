// SPDX-License-Identifier: MIT
#include "jobs/checks/result_check.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "base/legible.h"
#include "base/place.h"
#include "geometry/extent.h"
#include "geometry/mesh_triangle.h"
#include "geometry/triangle.h"
#include "geometry/triangle_tree.h"
#include "jobs/parts/part_places.h"
#include "measure/mesh_report.h"
#include "mesh/mesh_builder.h"
#include "mesh/welding.h"
#include "remesh/schemes/conformed.h"
#include "remesh/schemes/shape_comparison.h"

namespace remesher {
namespace {

// Degrees: good smallest angles, of the worst triangle and on average, and the least loss that
// gives a warning.
constexpr double kGoodWorst = 25, kGoodMean = 50, kWorthAWord = 0.5;

// Nothing lies farther from a surface than this within its box, in percent of the diagonal.
constexpr double kWholeDiagonal = 100;

// A surface no larger than this many steps of its coordinates is lost to rounding.
constexpr double kSteps = 64;

// A bound that was kept may be measured as slightly exceeded.
constexpr double kRounding = 1 + 1e-6;

// Digits shown, and the most that a double has.
constexpr int kDigits = 4, kMostDigits = 17;

// A coordinate below this share of the parts' size is shown as 0.
constexpr double kNothing = 1e-6;

// The most corners of a mesh whose distances are measured, evenly among all.
constexpr std::size_t kMostSampled = 20'000;

std::string number(double x) { return inDigits(x, kDigits); }

struct WorstTriangle {
  double angle = kInfinity;
  Vec3 centre = Vec3::Zero();
};

// Angles are measured as the part is shown.
WorstTriangle worstTriangle(const std::vector<io::Part>& parts) {
  WorstTriangle worst;
  const std::vector<PartPlace> places = placesOf(parts);
  for (std::size_t n = 0; n < parts.size(); ++n) {
    const TriangleMesh& mesh = parts[n].mesh;
    const auto stretch = stretchAt(places[n].toWorld);
    const auto shown = [&](const Vec3& p) { return stretch ? Vec3(*stretch * p) : p; };
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
      const auto [a, b, c] = cornersOf(mesh, t);
      const double angle = minAngle(shown(a), shown(b), shown(c));
      if (angle < worst.angle) worst = {angle, inWorldOf(parts[n], (a + b + c) / 3)};
    }
  }
  return worst;
}

// The box of all vertices; without any, `low` is above `high`.
struct CoordinateRange {
  Vec3 low = Vec3::Constant(kInfinity), high = -low;
  bool isSingle = false;  // of any of them
  double size() const { return (high - low).maxCoeff(); }
  double largest() const { return std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()); }
};

enum class Seen { AsWritten, InWorld };

CoordinateRange rangeOf(const std::vector<io::Part>& parts, Seen seen) {
  CoordinateRange range;
  for (const io::Part& part : parts) {
    range.isSingle = range.isSingle || part.mesh.isSingle;
    for (const Vec3& own : part.mesh.positions) {
      const Vec3 p = seen == Seen::InWorld ? inWorldOf(part, own) : own;
      range.low = range.low.cwiseMin(p);
      range.high = range.high.cwiseMax(p);
    }
  }
  return range;
}

// The middle of all vertices, if their coordinates are too coarse for a shape so small.
std::optional<Vec3> placeOfRounding(const std::vector<io::Part>& parts) {
  const CoordinateRange range = rangeOf(parts, Seen::AsWritten);
  const double step = range.isSingle ? std::numeric_limits<float>::epsilon()
                                     : std::numeric_limits<double>::epsilon();
  if (range.size() < 0 || range.size() > kSteps * step * range.largest()) return {};
  return (range.low + range.high) / 2;
}

// "message, the first near (…).", for the first edge with a wanted number of triangles.
Warning withFirstEdge(Warning warning, const std::vector<io::Part>& parts,
                      const std::function<bool(std::size_t triangles)>& isWanted) {
  for (const io::Part& part : parts) {
    const Welding welding(part.mesh);
    const auto at = [&](Index h) -> const Vec3& { return part.mesh.positions[welding.corners[h]]; };
    std::optional<Vec3> middle;
    welding.forEachEdge([&](std::span<const Index> edge) {
      if (!middle && isWanted(edge.size())) middle = (at(edge[0]) + at(nextCorner(edge[0]))) / 2;
    });
    if (!middle) continue;
    warning.at = inWorldOf(part, *middle);
    const std::string place = placeInWords(*warning.at, parts);
    warning.message.append(", the first near (").append(place).append(").");
    return warning;
  }
  warning.message.append(".");
  return warning;
}

// NON_MANIFOLD_VERTICES_LEFT, looked for only where the Euler characteristic counts more fans of
// triangles than vertices.
std::vector<Warning> pointsLeft(const MeshReport& report, const std::vector<io::Part>& parts) {
  const long fans = report.eulerCharacteristic + long(report.triangles / 2);
  if (report.boundaryEdges > 0 || fans <= long(report.vertices)) return {};
  std::size_t count = 0;
  std::optional<Vec3> first;
  for (const io::Part& part : parts) {
    const std::vector<Index> touching = touchingVertices(Welding(part.mesh));
    count += touching.size();
    if (!first && !touching.empty()) first = inWorldOf(part, part.mesh.positions[touching.front()]);
  }
  if (!first) return {};
  return {{"NON_MANIFOLD_VERTICES_LEFT",
           "Bodies touch in single points, which were left, the first near (" +
               placeInWords(*first, parts) + ").",
           count, first}};
}

bool isWorse(double after, double before, double good) {
  return after < std::min(before, good) - kWorthAWord;
}

// The smallest angles that are worse, such as "17° on average, not 34°", joined; empty if none is.
std::string worseAngles(const AngleStatistics& before, const AngleStatistics& after) {
  std::string text;
  const auto add = [&](double now, const char* which, double then) {
    if (!text.empty()) text.append(", and of ");
    text.append(number(now)).append(which).append(number(then)).append("°");
  };
  if (isWorse(after.mean, before.mean, kGoodMean))
    add(after.mean, "° on average, not ", before.mean);
  if (isWorse(after.worst, before.worst, kGoodWorst))
    add(after.worst, "° in the worst, not ", before.worst);
  return text;
}

std::size_t more(std::size_t after, std::size_t before) {
  return after > before ? after - before : 0;
}

}  // namespace

double checkedUnit(const TriangleMesh& mesh) {
  const double size = extentOf(mesh).diagonal();
  return size > 0 && std::isfinite(size) ? std::ldexp(1.0, -std::ilogb(size)) : 1;
}

std::vector<Vec3> inUnits(std::vector<Vec3> positions, double unit) {
  for (Vec3& p : positions) p *= unit;
  return positions;
}

std::string placeInWords(const Vec3& p, const std::vector<io::Part>& parts) {
  const CoordinateRange range = rangeOf(parts, Seen::InWorld);
  int digits = kDigits;
  for (double reach = range.size(); reach < range.largest() && digits < kMostDigits; reach *= 10)
    ++digits;
  const double nothing = kNothing * range.size();
  std::string text;
  for (const double x : {p.x(), p.y(), p.z()})
    text.append(text.empty() ? "" : ", ").append(inDigits(std::abs(x) < nothing ? 0 : x, digits));
  return text;
}

std::vector<Warning> worseThanGiven(const BeforeAndAfter& reports,
                                    const std::vector<io::Part>& result) {
  const auto& [before, after] = reports;
  std::vector<Warning> warnings;
  const std::string angles = worseAngles(before.minAngle, after.minAngle);
  if (!angles.empty() && !after.quads) {  // half of a quad is no triangle of its own
    const Vec3 worst = worstTriangle(result).centre;
    warnings.push_back({"ANGLES_WORSE",
                        "Triangles are worse than those given: smallest angles of " + angles +
                            ". The worst lies near (" + placeInWords(worst, result) +
                            "). More vertices help where parts are thinner than edges are long.",
                        1, worst});
  }
  if (const std::size_t made = more(after.degenerateTriangles, before.degenerateTriangles)) {
    const Vec3 worst = worstTriangle(result).centre;
    warnings.push_back({"DEGENERATE_TRIANGLES_MADE",
                        "Triangles of the result have no area: parts of the surface are too thin "
                        "for its numbers, as near (" +
                            placeInWords(worst, result) + ").",
                        made, worst});
  }
  if (const std::size_t made = more(after.nonManifoldEdges, before.nonManifoldEdges))
    warnings.push_back(withFirstEdge(
        {"NON_MANIFOLD_EDGES_MADE",
         "Parts of the surface that lie on each other share edges of the result", made},
        result, [](std::size_t triangles) { return triangles > 2; }));
  if (before.boundaryEdges == 0 && after.boundaryEdges > 0)
    warnings.push_back(withFirstEdge(
        {"SURFACE_OPENED", "Edges of the result are open, though the surface given was closed",
         after.boundaryEdges},
        result, [](std::size_t triangles) { return triangles == 1; }));
  return warnings;
}

std::vector<Warning> touchesLeft(const BeforeAndAfter& reports,
                                 const std::vector<io::Part>& result) {
  const auto& [before, after] = reports;
  if (after.nonManifoldEdges == 0) return pointsLeft(after, result);
  if (more(after.nonManifoldEdges, before.nonManifoldEdges) > 0) return {};
  return {withFirstEdge({"NON_MANIFOLD_EDGES_LEFT",
                         "Bodies touch along edges of more than two triangles, which were left",
                         after.nonManifoldEdges},
                        result, [](std::size_t triangles) { return triangles > 2; })};
}

std::vector<Warning> lostToRounding(const Report& report, const std::vector<io::Part>& result) {
  const MeshReport& after = report.output ? *report.output : report.input;
  const std::size_t flat = more(after.degenerateTriangles, report.input.degenerateTriangles);
  const bool isFar = report.fidelity && report.fidelity->hausdorff > kWholeDiagonal;
  if (!isFar && flat == 0) return {};
  const std::optional<Vec3> where = placeOfRounding(result);
  if (!where) return {};
  std::string text = "Triangles of the result have no area";
  if (isFar)
    text = "The result is " + number(report.fidelity->hausdorff) +
           " % of the diagonal away from the original";
  text.append(", near (").append(placeInWords(*where, result));
  text.append("): the model is smaller than what coordinates so far from the origin are rounded ");
  text.append("to. Move it to the origin first.");
  return {{"SHAPE_LOST_TO_ROUNDING", text, std::max<std::size_t>(flat, 1), where}};
}

std::vector<Warning> fartherThanAsked(const Report& report, const RemeshOptions& options) {
  if (!options.maxError || !report.fidelity) return {};
  const double found = report.fidelity->hausdorff;
  if (found <= *options.maxError * kRounding) return {};
  std::string text = "The result is " + number(found);
  text.append(" % of the diagonal away from the original, not ").append(number(*options.maxError));
  text.append(
      " % at most. The bound holds for the surface as it was repaired, and in numbers more ");
  return {{"MAX_ERROR_EXCEEDED", text.append("precise than those that are written.")}};
}

// "triangles" or "quads", and how many of them there are.
std::vector<Warning> beyondBudget(const Report& report, std::size_t budget) {
  const MeshReport& after = *report.output;
  const std::size_t faces = after.quads ? after.quads->count : after.triangles;
  if (faces <= budget) return {};
  const std::string kind = after.quads ? " quads" : " triangles";
  const std::string reason =
      report.stopped == Stopped::MaxError
          ? "to keep the bound on the error"
          : "for this surface (pieces: " + std::to_string(after.components) + ")";
  return {{"TOO_FEW_FACES", std::to_string(budget) + kind + " are too few " + reason +
                                ": the result has " + std::to_string(faces) + "."}};
}

std::vector<Warning> moreThanAsked(const Report& report, const RemeshOptions& options) {
  const MeshReport& after = *report.output;
  if (options.faces) return beyondBudget(report, *options.faces);
  const bool isWarned =
      after.quads ? report.stopped == Stopped::Fidelity : options.repair != Repair::Off;
  if (!isWarned || !options.vertices || after.vertices <= *options.vertices) return {};
  std::string surface = "for quads of this surface";
  if (!after.quads) {
    const long handles = std::max(0L, long(after.components) - after.eulerCharacteristic / 2);
    surface = "to keep the repaired surface (pieces: " + std::to_string(after.components) +
              ", handles: " + std::to_string(handles) + ") closed and free of crossings";
  }
  return {{"TOO_FEW_VERTICES", std::to_string(*options.vertices) + " vertices are too few " +
                                   surface + ": the result has " + std::to_string(after.vertices) +
                                   "."}};
}

FarthestCorner farthestCorner(const TriangleMesh& given, const TriangleMesh& made) {
  FarthestCorner farthest;
  const double unit = checkedUnit(given);
  const std::vector<Vec3> positions = inUnits(made.positions, unit);
  const TriangleTree tree(positions, made.indices);
  const std::size_t step = 1 + given.indices.size() / kMostSampled;
  for (std::size_t corner = 0; corner < given.indices.size(); corner += step) {
    const Vec3& p = given.positions[given.indices[corner]];
    const double distance = std::sqrt(tree.nearest(unit * p).squaredDistance) / unit;
    if (distance > farthest.distance) farthest = {distance, p};
  }
  return farthest;
}

std::vector<Warning> dentedPart(const Report& report, const PartPairs& parts,
                                const PartOptions& options) {
  if (!report.fidelity || report.fidelity->hausdorff <= 100 * kDented) return {};
  if (options.tooFew == TooFew::Raise) return {};
  std::size_t part = parts.results.size();
  FarthestCorner farthest;
  for (std::size_t i = 0; i < parts.results.size(); ++i) {
    const io::Part& given = parts.originals[i];
    if (!given.finer.empty() || parts.results[i].mesh.indices.empty()) continue;
    const FarthestCorner found = farthestCorner(given.mesh, parts.results[i].mesh);
    const double distance = found.distance * longestOf(given);
    if (distance > farthest.distance) farthest = {distance, inWorldOf(given, found.at)}, part = i;
  }
  if (part == parts.results.size()) return {};
  const TriangleMesh &given = parts.originals[part].mesh, &made = parts.results[part].mesh;
  // Quads need not leave a shape that has no more vertices than they have.
  const bool isCoarse = made.isQuads && countPlaces(given.positions) <= countPlaces(made.positions);
  if (!isCoarse && !isFaceted(buildMesh(given))) return {};
  // Nobody knows how many quads, or vertices between textures, that takes.
  const std::size_t enough = made.isQuads ? 0 : fewestConformed(given);
  if (enough > 0 && enough <= countPlaces(made.positions)) return {};
  std::string text = "The part is up to " + number(report.fidelity->hausdorff);
  text.append(" % of the diagonal away, most of all near (");
  text.append(placeInWords(farthest.at, parts.originals)).append("). ");
  text.append(enough > 0 ? "As many as " + std::to_string(enough) + " vertices keep"
                         : std::string("More ") + (made.isQuads ? "quads" : "vertices") + " keep");
  return {{"SHAPE_TAKES_MORE", text.append(" its shape."), 1, farthest.at}};
}

std::vector<Warning> resultWarnings(const Report& report, const std::vector<io::Part>& result,
                                    const RemeshOptions& options) {
  std::vector<Warning> all = worseThanGiven({report.input, *report.output}, result);
  for (const auto& more : {lostToRounding(report, result), fartherThanAsked(report, options),
                           moreThanAsked(report, options)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace remesher
