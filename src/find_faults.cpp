// SPDX-License-Identifier: MIT
// What is broken, and which edges bend: found, and left as it is.
#include <utility>

#include "io/formats.h"
#include "jobs/part_repair.h"
#include "jobs/parts/part_joining.h"
#include "jobs/run_guards.h"
#include "measure/edge_report.h"
#include "mesh/welding.h"
#include "remesher.h"

namespace remesher {

FaultReport findFaults(const TriangleMesh& mesh) {
  return faultsOf(joinedPlaces({io::Part{"", mesh, {}}}, {}));
}

FaultReport findFaultsInFile(const FileBundle& input) {
  io::Model model = io::read(input.file, input.resources);
  return inFile(input.file.name,
                [&] { return faultsOf(joinedPlaces(std::move(model.parts), {})); });
}

EdgeReport findEdges(const TriangleMesh& mesh) {
  const std::vector<io::Part> parts = joinedPlaces({io::Part{"", mesh, {}}}, {});
  const TriangleMesh& joined = parts.front().mesh;
  return reportEdges(joined, Welding(joined));
}

}  // namespace remesher
