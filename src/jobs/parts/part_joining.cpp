// SPDX-License-Identifier: MIT
#include "jobs/parts/part_joining.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "base/legible.h"
#include "base/place.h"
#include "jobs/parts/part_lengths.h"
#include "jobs/parts/part_places.h"
#include "mesh/joining.h"
#include "mesh/welding.h"

namespace remesher {

std::vector<Warning> settleAttributes(std::vector<io::Part>& parts) {
  std::map<std::string, std::size_t> settled;  // values, by semantic
  for (io::Part& part : parts)
    for (Attribute& attribute : part.mesh.attributes)
      for (float& value : attribute.values) {
        if (std::isfinite(value)) continue;
        value = 0;
        ++settled[attribute.semantic];
      }
  std::vector<Warning> warnings;
  for (const auto& [semantic, count] : settled)
    warnings.push_back({"NON_FINITE_ATTRIBUTE",
                        "Values of " + legible(semantic) + " that are not finite are read as 0.",
                        count});
  return warnings;
}

std::vector<io::Part> joinedPlaces(std::vector<io::Part> parts, const PartOptions& options) {
  for (io::Part& part : parts) {
    requireValid(part.mesh);
    joinNoise(part.mesh);
    const double growth = growthOf(firstPlace(part));
    double near = options.weld.value_or(0) / 100 * diagonalOf(part.mesh);
    if (options.lengths.weld && growth > 0) near = *options.lengths.weld / growth;
    // Where the surface is closed nothing is to be joined: a thin wall would become two sheets.
    if (near > 0) joinNear(part.mesh, near, openVerticesOf(part.mesh, Welding(part.mesh)));
  }
  return parts;
}

std::vector<Warning> placesRounded(const std::vector<io::Part>& given) {
  std::size_t count = 0;
  for (const io::Part& part : given) {
    requireValid(part.mesh);
    TriangleMesh plain;
    plain.positions = part.mesh.positions, plain.indices = part.mesh.indices;
    plain.isSingle = part.mesh.isSingle;
    joinNoise(plain);
    const std::vector<Index> first = weld(plain.positions);
    for (Index v = 0; v < first.size(); ++v)
      count += part.mesh.positions[v] != part.mesh.positions[first[v]];
  }
  if (count == 0) return {};
  return {{"PLACES_JOINED",
           "Vertices differ from others only by rounding, so that exact readers find cracks there: "
           "repair makes their places one.",
           count}};
}

std::vector<Warning> looseTriangles(const MeshReport& report, const std::vector<io::Part>& parts) {
  const std::size_t corners = 3 * (report.triangles - report.degenerateTriangles);
  const auto loose = [](const io::Part& part) { return isLoose(part.mesh); };
  if (report.triangles < 2 || report.boundaryEdges < corners ||
      !std::all_of(parts.begin(), parts.end(), loose))
    return {};
  std::optional<double> percent;
  for (const io::Part& part : parts)
    if (const auto needed = percentThatJoins(part.mesh))
      percent = std::max(percent.value_or(0), *needed);
  std::string message = "No triangle shares an edge with another: each is a surface of its own.";
  if (percent)
    message +=
        " Their corners are near to each other: --weld " + inDigits(*percent, 6) + " joins them.";
  return {{"TRIANGLES_NOT_JOINED", message, report.triangles}};
}

}  // namespace remesher
