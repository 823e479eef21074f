// SPDX-License-Identifier: MIT
#include "jobs/checks/wanted_check.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/legible.h"
#include "geometry/mesh_triangle.h"
#include "geometry/triangle.h"
#include "jobs/checks/result_check.h"
#include "jobs/parts/part_places.h"
#include "mesh/welding.h"

namespace remesher {
namespace {

constexpr int kFigures = 4;  // of numbers in messages

// The worst of what was measured, and how much of it keeps a limit.
class Tally {
 public:
  explicit Tally(double asked) : asked_(asked) {}

  // isKept, isWorse: of `value`. at: called if it is the worst so far.
  template <class Place>
  void add(double value, bool isKept, bool isWorse, const Place& at) {
    ++all_;
    kept_ += isKept ? 1 : 0;
    if (all_ > 1 && !isWorse) return;
    worst_ = value;
    at_ = at();
  }

  double worst() const { return worst_; }

  WantedFigure figure() const {
    WantedFigure figure;
    figure.asked = asked_;
    figure.worst = worst_;
    figure.missed = all_ - kept_;
    figure.kept = all_ == 0 ? 100 : 100 * double(kept_) / double(all_);
    if (kept_ < all_) figure.at = at_;
    return figure;
  }

 private:
  double asked_, worst_ = 0;
  std::size_t all_ = 0, kept_ = 0;
  Vec3 at_ = Vec3::Zero();
};

struct Tallies {
  Tally shortest, longest, angle;

  explicit Tallies(const RemeshOptions& options)
      : shortest(options.minEdge.value_or(0)),
        longest(options.maxEdge.value_or(0)),
        angle(options.minAngle.value_or(0)) {}

  void add(const TriangleMesh& mesh, const Transform& toWorld, const RemeshOptions& options);
  WantedReport report(const RemeshOptions& options) const;
};

void addEdges(const TriangleMesh& mesh, const Transform& toWorld, Tallies& tallies,
              const RemeshOptions& options) {
  const Welding welding(mesh);
  welding.forEachEdge([&](std::span<const Index> edge) {
    const Vec3& a = mesh.positions[welding.corners[edge[0]]];
    const Vec3& b = mesh.positions[welding.corners[nextCorner(edge[0])]];
    const double length = (toWorld.linear() * (b - a)).norm();
    const auto middle = [&] { return Vec3(toWorld * Vec3((a + b) / 2)); };
    if (options.minEdge)
      tallies.shortest.add(length, length >= *options.minEdge, length < tallies.shortest.worst(),
                           middle);
    if (options.maxEdge)
      tallies.longest.add(length, length <= *options.maxEdge, length > tallies.longest.worst(),
                          middle);
  });
}

void addAngles(const TriangleMesh& mesh, const Transform& toWorld, Tally& tally, double wanted) {
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const Triangle at = cornersOf(mesh, t);
    const Vec3 b = toWorld.linear() * (at[1] - at[0]), c = toWorld.linear() * (at[2] - at[0]);
    const double angle = degrees(minAngle(Vec3::Zero(), b, c));
    tally.add(angle, angle >= wanted, angle < tally.worst(),
              [&] { return Vec3(toWorld * Vec3((at[0] + at[1] + at[2]) / 3)); });
  }
}

void Tallies::add(const TriangleMesh& mesh, const Transform& toWorld,
                  const RemeshOptions& options) {
  if (options.minEdge || options.maxEdge) addEdges(mesh, toWorld, *this, options);
  if (options.minAngle) addAngles(mesh, toWorld, angle, *options.minAngle);
}

WantedReport Tallies::report(const RemeshOptions& options) const {
  WantedReport report;
  if (options.minEdge) report.minEdge = shortest.figure();
  if (options.maxEdge) report.maxEdge = longest.figure();
  if (options.minAngle) report.minAngle = angle.figure();
  return report;
}

double areaOf(const std::vector<io::Part>& parts) {
  double area = 0;
  const std::vector<PartPlace> places = placesOf(parts);
  for (std::size_t n = 0; n < parts.size(); ++n) {
    if (!parts[n].finer.empty()) continue;
    const Eigen::Matrix3d toWorld = places[n].toWorld.linear();
    for (std::size_t t = 0; t < parts[n].mesh.triangleCount(); ++t) {
      const auto [a, b, c] = cornersOf(parts[n].mesh, t);
      const Vec3 first = toWorld * (b - a), second = toWorld * (c - a);
      area += first.cross(second).norm() / 2;
    }
  }
  return area;
}

// Of triangles with edges of such a length.
double verticesFor(double area, double length) {
  return 2 * area / (std::sqrt(3.0) * length * length);
}

std::string shown(double x) { return inDigits(x, kFigures); }

// The number of vertices asked for may be the reason.
std::string byNumber(bool isReason, double enough) {
  if (!isReason) return "";
  return " The number of vertices that was asked for does not allow it: about " +
         std::to_string(std::llround(enough)) + " would.";
}

// The limits that the input itself breaks.
std::string byCurves(const UnmetCount& unmet, std::size_t missed, const std::string& what) {
  const std::size_t held = std::min(unmet.byCurves, missed);
  if (held == 0) return "";
  return " Of these, " + std::to_string(held) + what;
}

struct Missed {
  const char* code;
  const WantedFigure& figure;
  std::string beginning, reason;
};

Warning warningOn(const Missed& missed, const std::vector<io::Part>& result) {
  const WantedFigure& figure = missed.figure;
  std::string text = missed.beginning + shown(figure.worst);
  text.append(", near (").append(placeInWords(*figure.at, result)).append(").");
  text.append(missed.reason);
  return {missed.code, text, figure.missed, figure.at};
}

}  // namespace

void checkWanted(const RemeshOptions& options) {
  for (const auto& [name, value] :
       {std::pair{"minEdge", options.minEdge}, std::pair{"maxEdge", options.maxEdge},
        std::pair{"minAngle", options.minAngle}})
    if (value && !(*value > 0))
      throw Error(ErrorCode::InvalidOption, std::string(name) + " is not above 0.",
                  "Edges are limited by lengths in the units of the model, angles in degrees.");
  if (options.minAngle && *options.minAngle > 60)
    throw Error(ErrorCode::InvalidOption, "minAngle is above 60.",
                "The smallest angle of a triangle is 60 degrees at most; ask for up to 30.");
  if (options.minEdge && options.maxEdge && *options.minEdge > *options.maxEdge)
    throw Error(ErrorCode::InvalidOption,
                "minEdge is " + shown(*options.minEdge) + ", longer than maxEdge, " +
                    shown(*options.maxEdge) + ".",
                "Leave room between them: maxEdge at least 2.5 times minEdge.");
}

WantedReport wantedOf(const TriangleMesh& mesh, const RemeshOptions& options) {
  Tallies tallies(options);
  tallies.add(mesh, Transform::Identity(), options);
  return tallies.report(options);
}

std::optional<WantedReport> wantedOf(const std::vector<io::Part>& result,
                                     const RemeshOptions& options) {
  if (!wantsOfEach(options)) return {};
  const std::vector<PartPlace> places = placesOf(result);
  Tallies tallies(options);
  for (std::size_t n = 0; n < result.size(); ++n)
    if (result[n].finer.empty()) tallies.add(result[n].mesh, places[n].toWorld, options);
  return tallies.report(options);
}

std::vector<Warning> wantedMissed(const MeshReport& output, const std::vector<io::Part>& result,
                                  const RemeshOptions& options, const Unmet& unmet) {
  std::vector<Warning> warnings;
  if (!output.wanted) return warnings;
  const auto& [minEdge, maxEdge, minAngle] = *output.wanted;
  const bool isNumbered = asksForNumber(options);
  const double area = isNumbered ? areaOf(result) : 0;
  const auto vertices = double(output.vertices);
  if (minEdge && minEdge->missed > 0) {
    const double most = verticesFor(area, minEdge->asked / kShortestOfSize);
    warnings.push_back(warningOn(
        {"EDGES_TOO_SHORT", *minEdge,
         "Edges are shorter than " + shown(minEdge->asked) + ", the shortest ",
         byCurves(unmet.shortEdges, minEdge->missed,
                  " lie between sharp edges, borders or corners that are nearer to each other.") +
             byNumber(isNumbered && vertices > most, most)},
        result));
  }
  if (maxEdge && maxEdge->missed > 0) {
    const double least = verticesFor(area, maxEdge->asked / kLongestOfSize);
    warnings.push_back(warningOn(
        {"EDGES_TOO_LONG", *maxEdge,
         "Edges are longer than " + shown(maxEdge->asked) + ", the longest ",
         byCurves(unmet.longEdges, maxEdge->missed, " lie on borders that were to be kept.") +
             byNumber(isNumbered && vertices < least, least)},
        result));
  }
  if (minAngle && minAngle->missed > 0)
    warnings.push_back(warningOn(
        {"ANGLES_TOO_SMALL", *minAngle,
         "Triangles have angles below " + shown(minAngle->asked) + " degrees, the smallest ",
         byCurves(unmet.smallAngles, minAngle->missed,
                  " lie between sharp edges or borders that meet at small angles or are near to "
                  "each other.")},
        result));
  return warnings;
}

}  // namespace remesher
