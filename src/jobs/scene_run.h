// SPDX-License-Identifier: MIT
// Remeshes all parts of a scene, once or to several levels of detail.
#pragma once

#include <string>
#include <vector>

#include "base/part_options.h"
#include "base/progress.h"
#include "base/report.h"
#include "io/model/model.h"
#include "jobs/parts/part_report.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

// All parts remeshed, and the report without reading and writing.
struct SceneRun {
  std::vector<io::Part> parts;
  std::vector<std::vector<InputPlace>> places;  // of each part's corners, where textures are baked
  std::vector<std::vector<Index>> crossings;    // per part, see crossingsMade
  Report report;
  std::size_t mirrors = 0, quadParts = 0;  // of all parts; see RemeshOutcome
  std::vector<PairedPart> paired;          // likewise
  Unmet unmet;                             // likewise
};

// How a file of this name holds parts.
Held heldIn(const std::string& outputName);

// Remeshes parts of any size, for a file that holds each by itself; the options' levels of detail
// are left out. Throws the Errors of requireValid, of remeshSurface and of PartTargets.
SceneRun remeshParts(const std::vector<io::Part>& originals, const PartOptions& options,
                     const Progress& progress);

// All levels of detail, each from the originals. The finest is the first: it is remeshed with the
// options as given, and its report has those of the others. Reports describe the parts as the file
// holds them.
std::vector<SceneRun> remeshLevels(const std::vector<io::Part>& originals, Held held,
                                   const PartOptions& options, const Progress& progress);

// The coarser levels of detail of a painted result, simplified from it: their corners keep its
// attributes, so that all levels share its maps. originals: what the result was made of, to which
// the distances refer. A level that cannot be as coarse as asked for is as coarse as it can be.
std::vector<SceneRun> simplifiedLevels(const std::vector<io::Part>& originals,
                                       const SceneRun& finest, const PartOptions& options,
                                       const Progress& progress);

}  // namespace remesher
