// SPDX-License-Identifier: MIT
#include "jobs/part_run.h"

#include <utility>

#include "jobs/fewest_vertices.h"
#include "jobs/part_repair.h"

namespace remesher {

namespace {

// Vertices that the shape needs most are taken without looking for crossings.
bool isCrossedShape(const RemeshOutcome& outcome, const RemeshOptions& options) {
  return outcome.prefer == Prefer::Shape && options.repair != Repair::Off && !isSound(outcome.mesh);
}

RemeshOutcome remeshPart(PartInput part, const RemeshOptions& options, const Progress& progress) {
  using Run =
      RemeshOutcome (*)(const TriangleMesh&, Welding, const RemeshOptions&, const Progress&);
  const Run remeshed = asksForFewest(options) ? Run(remeshToFewest) : Run(remeshSurface);
  const auto stretch = stretchAt(part.place.toWorld);
  if (!stretch) return remeshed(part.mesh, std::move(part.welding), options, progress);
  RemeshOutcome outcome =
      remeshed(stretched(part.mesh, *stretch), std::move(part.welding), options, progress);
  outcome.mesh = relaxed(std::move(outcome.mesh), *stretch, part.mesh);
  outcome.tree.reset();
  return outcome;
}

}  // namespace

RemeshOutcome remeshAsShown(PartInput part, const PartTarget& target, const Progress& progress) {
  try {
    RemeshOptions options =
        target.unions.optionsOf(target.surface, target.targets.of(target.surface));
    RemeshOutcome outcome = remeshPart(part, options, progress);
    if (!isCrossedShape(outcome, options)) return outcome;
    options.prefer = Prefer::Even;
    return remeshPart(std::move(part), options, progress);
  } catch (const TooFewVertices& error) {
    target.targets.refuse(target.surface, error);
  }
}

RoundedMesh roundedOutcome(const TriangleMesh& original, RemeshOutcome& outcome, Repair repair) {
  if (repair != Repair::Off) return inSoundPrecisionOf(original, outcome);
  return inPrecisionOf(original, std::move(outcome.mesh));
}

io::Part withoutMesh(const io::Part& part) {
  return {part.name, {},          part.instances, part.groups,
          part.lods, part.source, part.finer,     part.hidden};
}

}  // namespace remesher
