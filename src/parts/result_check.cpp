// SPDX-License-Identifier: MIT
#include "parts/result_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "geometry/triangle.h"

namespace remesher {
namespace {

// Degrees: smallest angles that are good, of the worst triangle and on average, and how much less
// than before is worth a word.
constexpr double kGoodWorst = 25, kGoodMean = 50, kWorthAWord = 0.5;

std::string number(double x) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.4g", x);
  return digits.data();
}

struct WorstTriangle {
  double angle = std::numeric_limits<double>::infinity();
  Vec3 centre = Vec3::Zero();
};

WorstTriangle worstTriangle(const std::vector<io::Part>& parts) {
  WorstTriangle worst;
  for (const io::Part& part : parts)
    for (std::size_t i = 0; i + 2 < part.mesh.indices.size(); i += 3) {
      const Vec3& a = part.mesh.positions[part.mesh.indices[i]];
      const Vec3& b = part.mesh.positions[part.mesh.indices[i + 1]];
      const Vec3& c = part.mesh.positions[part.mesh.indices[i + 2]];
      const double angle = minAngle(a, b, c);
      if (angle < worst.angle) worst = {angle, (a + b + c) / 3};
    }
  return worst;
}

std::string place(const Vec3& p) {
  std::string text = number(p.x());
  for (const double x : {p.y(), p.z()}) text.append(", ").append(number(x));
  return text;
}

std::string angleMessage(const BeforeAndAfter& reports, const Vec3& where) {
  const AngleStatistics &before = reports.before.minAngle, &after = reports.after.minAngle;
  std::string text = "Triangles are worse than those given: smallest angles of ";
  text.append(number(after.mean)).append("° on average, not ").append(number(before.mean));
  text.append("°, and of ").append(number(after.worst)).append("° in the worst, not ");
  text.append(number(before.worst)).append("°, which lies near (").append(place(where));
  return text.append("). More vertices help where parts are thinner than edges are long.");
}

bool isWorse(double after, double before, double good) {
  return after < std::min(before, good) - kWorthAWord;
}

std::size_t more(std::size_t after, std::size_t before) {
  return after > before ? after - before : 0;
}

}  // namespace

std::vector<Warning> worseThanGiven(const BeforeAndAfter& reports,
                                    const std::vector<io::Part>& result) {
  const auto& [before, after] = reports;
  std::vector<Warning> warnings;
  const bool isMean = isWorse(after.minAngle.mean, before.minAngle.mean, kGoodMean);
  if (isMean || isWorse(after.minAngle.worst, before.minAngle.worst, kGoodWorst))
    warnings.push_back({"ANGLES_WORSE", angleMessage(reports, worstTriangle(result).centre)});
  const auto count = [&](const char* code, const char* message, std::size_t made) {
    if (made > 0) warnings.push_back({code, message, made});
  };
  count("DEGENERATE_TRIANGLES_MADE",
        "Triangles of the result have no area: parts of the surface are too thin for its numbers.",
        more(after.degenerateTriangles, before.degenerateTriangles));
  count("NON_MANIFOLD_EDGES_MADE",
        "Parts of the surface that lie on each other share edges of the result.",
        more(after.nonManifoldEdges, before.nonManifoldEdges));
  if (before.boundaryEdges == 0)
    count("SURFACE_OPENED", "Edges of the result are open, though the surface given was closed.",
          after.boundaryEdges);
  return warnings;
}

}  // namespace remesher
