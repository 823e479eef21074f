// SPDX-License-Identifier: MIT
// Whether a result is worse than what was given, by the report's own figures: then the report says
// so, and where.
#pragma once

#include <string>
#include <vector>

#include "base/options.h"
#include "base/report.h"
#include "io/model/model.h"

namespace remesher {

// "0.5, 2, -1e-3", with more digits where the parts are small beside their distance from the
// origin.
std::string placeInWords(const Vec3& p, const std::vector<io::Part>& parts);

// What the report says of both sides of a run.
struct BeforeAndAfter {
  const MeshReport& before;
  const MeshReport& after;
};

// A warning for each figure that is worse: ANGLES_WORSE, DEGENERATE_TRIANGLES_MADE,
// NON_MANIFOLD_EDGES_MADE, SURFACE_OPENED. Angles that are good all the same are no matter.
std::vector<Warning> worseThanGiven(const BeforeAndAfter& reports,
                                    const std::vector<io::Part>& result);

// SHAPE_LOST_TO_ROUNDING, where the result is no larger than what rounding leaves, and either has
// triangles without area that the original had not, or is farther away than the original is large.
std::vector<Warning> lostToRounding(const Report& report, const std::vector<io::Part>& result);

// MAX_ERROR_EXCEEDED, where a bound was asked for and what was measured lies beyond it.
std::vector<Warning> fartherThanAsked(const Report& report, const RemeshOptions& options);

// All of these that hold.
std::vector<Warning> resultWarnings(const Report& report, const std::vector<io::Part>& result,
                                    const RemeshOptions& options);

}  // namespace remesher
