// SPDX-License-Identifier: MIT
#include "jobs/inspected_model.h"

#include <utility>

#include "base/phase_clock.h"
#include "io/formats.h"
#include "jobs/inspected_parts.h"
#include "jobs/parts/part_joining.h"
#include "jobs/run_guards.h"
#include "jobs/thinned_parts.h"

namespace remesher {

InspectedModel inspectedMesh(const TriangleMesh& mesh) {
  PhaseClock clock;
  clock.enter("inspect");
  Report report;
  std::vector<io::Part> parts = joinedPlaces({io::Part{"", mesh, {}}}, {});
  const std::vector<Warning> settled = settleAttributes(parts);
  report.input = inspectScaled(parts);
  report.warnings = mergedByCode(settled, looseTriangles(report.input, parts));
  return {std::move(parts), timed(std::move(report), clock)};
}

InspectedModel inspectedFile(const File& file, const std::vector<File>& resources, Inspection how,
                             const Progress& progress) {
  PhaseClock clock;
  const Progress whole = progress.timedBy(clock);
  whole.phase("read", 0, kInspectedRead);
  io::Model model = io::read(file, resources);
  const Progress work = whole.phase("inspect", kInspectedRead, 1);
  Report report;
  report.input = inFile(file.name, [&] {
    model.warnings = mergedByCode(model.warnings, roomWarnings(model.parts));
    if (how == Inspection::Close)
      model.warnings = mergedByCode(model.warnings, placesRounded(model.parts));
    model.parts = joinedPlaces(std::move(model.parts), {});
    work.at(0.1);
    return inspectScaled(model.parts, work.part(0.1, 1));
  });
  report.warnings = mergedByCode(model.warnings, looseTriangles(report.input, model.parts));
  return {std::move(model.parts), timed(std::move(report), clock)};
}

}  // namespace remesher
