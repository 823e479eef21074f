// SPDX-License-Identifier: MIT
// Joins vertices of parts before any other step, and settles the values of their attributes.
#pragma once

#include <vector>

#include "base/part_options.h"
#include "base/report.h"
#include "io/model/model.h"

namespace remesher {

// Removes noise around zero, and joins places nearer than `weld` of the options says, which is of
// each part's own diagonal. Throws the Errors of requireValid.
std::vector<io::Part> joinedPlaces(std::vector<io::Part> parts, const PartOptions& options);

// PLACES_JOINED, if vertices have the places of others but for rounding, as joinedPlaces and repair
// find them: exact readers see the surface open there. Throws the Errors of requireValid.
std::vector<Warning> placesRounded(const std::vector<io::Part>& given);

// Makes values of attributes that are not finite 0, since they would spread over the result.
// Returns NON_FINITE_ATTRIBUTE for each semantic that had any. Readers of files do so themselves.
std::vector<Warning> settleAttributes(std::vector<io::Part>& parts);

// TRIANGLES_NOT_JOINED if no triangle of any part shares an edge with another; says what would join
// them.
std::vector<Warning> looseTriangles(const MeshReport& report, const std::vector<io::Part>& parts);

}  // namespace remesher
