// SPDX-License-Identifier: MIT
// Parts remeshed, and looked at, as they look where the file shows them.
#pragma once

#include "base/options.h"
#include "base/progress.h"
#include "base/report.h"
#include "io/model/model.h"
#include "jobs/part_places.h"
#include "jobs/part_targets.h"
#include "jobs/part_unions.h"
#include "jobs/precision.h"
#include "mesh/welding.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

struct PartInput {
  const TriangleMesh& mesh;
  Welding welding;
  const PartPlace& place;
};

// The number of a part, or of a union of several, with what is asked of it.
struct PartTarget {
  const PartTargets& targets;
  const PartUnions& unions;
  std::size_t surface;
};

// The outcome is in the part's own space; its tree only where the part looks as it does there.
RemeshOutcome remeshAsShown(PartInput part, const PartTarget& target, const Progress& progress);

// What remeshing has made, in the original's precision: sound if that was repaired.
RoundedMesh roundedOutcome(const TriangleMesh& original, RemeshOutcome& outcome, Repair repair);

// All of a part but its mesh.
io::Part withoutMesh(const io::Part& part);

// The report on parts of any size. Throws Error as requireValid does.
MeshReport inspectScaled(const std::vector<io::Part>& parts);

}  // namespace remesher
