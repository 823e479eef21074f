// SPDX-License-Identifier: MIT
// Finds the faults of a mesh, and the edges that bend, and changes nothing.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "jobs/checks/repair_room.h"
#include "jobs/inspected_model.h"
#include "jobs/part_repair.h"
#include "jobs/parts/part_joining.h"
#include "jobs/parts/part_report.h"
#include "jobs/run_guards.h"
#include "measure/edge_report.h"
#include "mesh/welding.h"
#include "remesher.h"

namespace remesher {
namespace {

bool isSaid(const std::vector<Warning>& warnings) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [](const Warning& warning) { return warning.code == "FAULTS_NOT_SOUGHT"; });
}

// Of triangles that lie unfavourably the search takes more than their number tells.
CloseInspection withFaults(InspectedModel model) {
  CloseInspection close{std::move(model.report), std::nullopt};
  std::vector<Warning>& warnings = close.report.warnings;
  if (isSaid(warnings)) return close;
  if (const std::optional<Warning> lacking = noRoomForFaults(model.parts)) {
    warnings.push_back(*lacking);
    return close;
  }
  try {
    std::vector<Warning> found;
    close.faults = withinMemory([&] {
      found = warningsOfOneSided(model.parts);
      const std::vector<Warning> meeting = warningsOfMeeting(model.parts);
      found.insert(found.end(), meeting.begin(), meeting.end());
      return faultsOf(model.parts);
    });
    warnings.insert(warnings.end(), found.begin(), found.end());
  } catch (const Error& error) {
    if (error.code != ErrorCode::OutOfMemory) throw;
    warnings.push_back({"FAULTS_NOT_SOUGHT",
                        std::string("Faults could not be looked for. ") + error.what(),
                        close.report.input.triangles});
  }
  return close;
}

}  // namespace

CloseInspection inspectClosely(const TriangleMesh& mesh) {
  InspectedModel model = inspectedMesh(mesh);
  std::vector<Warning>& warnings = model.report.warnings;
  warnings = mergedByCode(placesRounded({io::Part{"", mesh, {}}}), warnings);
  return withFaults(std::move(model));
}

CloseInspection inspectFileClosely(const FileBundle& input, const Progress& progress) {
  InspectedModel model = inspectedFile(input.file, input.resources, Inspection::Close, progress);
  return inFile(input.file.name, [&] { return withFaults(std::move(model)); });
}

EdgeReport findEdges(const TriangleMesh& mesh) {
  const std::vector<io::Part> parts = joinedPlaces({io::Part{"", mesh, {}}}, {});
  const TriangleMesh& joined = parts.front().mesh;
  return reportEdges(joined, Welding(joined));
}

}  // namespace remesher
