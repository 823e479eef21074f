// SPDX-License-Identifier: MIT
// Remeshes parts as they look where the file shows them, and rounds the results.
#pragma once

#include <string>
#include <vector>

#include "base/options.h"
#include "base/progress.h"
#include "base/report.h"
#include "io/model/model.h"
#include "jobs/checks/precision.h"
#include "jobs/parts/part_places.h"
#include "jobs/parts/part_targets.h"
#include "jobs/parts/part_unions.h"
#include "mesh/welding.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

struct PartInput {
  const TriangleMesh& mesh;
  Welding welding;
  const PartPlace& place;
};

// A surface to remesh (a part, or a union of parts) by its number, the targets of all surfaces, and
// the guides on this one, in its own space.
struct PartTarget {
  const PartTargets& targets;
  const PartUnions& unions;
  std::size_t surface;
  std::vector<Guide> guides = {};
};

// The outcome is in the part's own space. It has a tree only if the part is not stretched at its
// place.
RemeshOutcome remeshAsShown(PartInput part, const PartTarget& target, const Progress& progress);

struct ShownMesh {
  const TriangleMesh& mesh;
  const PartPlace& place;
};

struct UncrossedOutcome {
  RemeshOutcome outcome;
  std::vector<Index> crossings;  // see crossingsMade
};

// The outcome of remeshing a part, or another with as many vertices if the part intersects itself
// nowhere and the outcome does: with the crossings mended, or of the other kind of triangles.
UncrossedOutcome uncrossedAsShown(const ShownMesh& part, const PartTarget& target,
                                  RemeshOutcome made, const Progress& progress);

// The outcome's mesh in the original's precision; kept sound if the original was repaired.
RoundedMesh roundedOutcome(const TriangleMesh& original, RemeshOutcome& outcome, Repair repair);

// Whether any triangle has an area. Among several parts one that is no surface is passed on.
bool isSurface(const TriangleMesh& mesh);

// PASSED_ON, with the part's name.
Warning passedOn(const io::Part& part, const std::string& reason);

// The places of the mesh's own corners on the mesh itself.
std::vector<InputPlace> ownPlaces(const TriangleMesh& mesh);

// A copy of the part without its mesh.
io::Part withoutMesh(const io::Part& part);

}  // namespace remesher
