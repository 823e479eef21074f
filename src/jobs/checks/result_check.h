// SPDX-License-Identifier: MIT
// Finds whether a result is worse than the input by the report's own figures; the warnings say so,
// and where.
#pragma once

#include <string>
#include <vector>

#include "base/part_options.h"
#include "base/report.h"
#include "io/model/model.h"
#include "jobs/parts/part_report.h"

namespace remesher {

// "0.5, 2, -1e-3", with more digits where the parts are small beside their distance from the
// origin; a millionth of their size is 0.
std::string placeInWords(const Vec3& p, const std::vector<io::Part>& parts);

// A power of two that brings a mesh to about unit size: trees compare distances in single
// precision.
double checkedUnit(const TriangleMesh& mesh);
std::vector<Vec3> inUnits(std::vector<Vec3> positions, double unit);

// The report's figures before and after a run.
struct BeforeAndAfter {
  const MeshReport& before;
  const MeshReport& after;
};

// A warning for each figure that is worse: ANGLES_WORSE, DEGENERATE_TRIANGLES_MADE,
// NON_MANIFOLD_EDGES_MADE, SURFACE_OPENED. Angles that are still good give no warning.
std::vector<Warning> worseThanGiven(const BeforeAndAfter& reports,
                                    const std::vector<io::Part>& result);

// NON_MANIFOLD_EDGES_LEFT, if a repaired surface has edges of more than two triangles, and the
// given one had as many. NON_MANIFOLD_VERTICES_LEFT, if it has none and is closed, but touches
// itself in points.
std::vector<Warning> touchesLeft(const BeforeAndAfter& reports,
                                 const std::vector<io::Part>& result);

// SHAPE_LOST_TO_ROUNDING, if the result is no larger than a few rounding steps, and either has
// triangles without area that the original had not, or is farther away than the original is large.
std::vector<Warning> lostToRounding(const Report& report, const std::vector<io::Part>& result);

// MAX_ERROR_EXCEEDED, if a bound was asked for and the measured distance exceeds it.
std::vector<Warning> fartherThanAsked(const Report& report, const RemeshOptions& options);

// TOO_FEW_VERTICES, if a repaired surface has more vertices than were asked for, or if quads
// missed the number for more.
std::vector<Warning> moreThanAsked(const Report& report, const RemeshOptions& options);

// A part is visibly dented from this share of its diagonal on.
inline constexpr double kDented = 0.01;

// The corner of a given mesh that is farthest from its result, of 20,000 at most.
struct FarthestCorner {
  double distance = -1;
  Vec3 at = Vec3::Zero();
};
FarthestCorner farthestCorner(const TriangleMesh& given, const TriangleMesh& made);

// SHAPE_TAKES_MORE, if the result is dented, most where a part is made of facets, or of no more
// vertices than its quads, and has too few vertices or quads for its shape. Levels of detail are
// meant to be so.
std::vector<Warning> dentedPart(const Report& report, const PartPairs& parts,
                                const PartOptions& options);

// All of these warnings that apply, but for dentedPart.
std::vector<Warning> resultWarnings(const Report& report, const std::vector<io::Part>& result,
                                    const RemeshOptions& options);

}  // namespace remesher
