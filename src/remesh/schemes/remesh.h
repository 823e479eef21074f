// SPDX-License-Identifier: MIT
// The remesher as one function: build, original surface, scheme, result.
#pragma once

#include <optional>
#include <vector>

#include "base/input_place.h"
#include "base/part_options.h"
#include "base/progress.h"
#include "base/report.h"
#include "base/unmet.h"
#include "geometry/triangle_tree.h"
#include "mesh/welding.h"

namespace remesher {

struct RemeshOutcome {
  TriangleMesh mesh;               // a vertex comes in as many copies as its attributes need
  std::vector<InputPlace> places;  // per corner of its triangles, if textures are to be baked
  Stopped stopped = Stopped::Target;
  std::size_t vertices = 0;  // distinct positions, without those that splitObtuse adds
  std::vector<Warning> warnings;
  std::size_t coincident = 0;  // vertices that a file would join; see moveApart
  // A tree of the input's triangles that are no lines, each once, over the input's positions.
  // Present if the run needed a tree and all these triangles are in the surface.
  std::optional<ListedTree> tree = {};
  Prefer prefer = Prefer::Even;  // or Shape
  // Planes about which quads are their own mirror images.
  std::vector<MirrorPlane> mirrors = {};
  Chosen chosen = {};         // the rule by which this mesh was taken
  std::size_t quadParts = 0;  // connected parts of quads
  std::size_t removed = 0;    // quads taken out to reach the number
  std::vector<PairedPart> paired = {};
  Unmet unmet = {};  // limits of edges and triangles that are not kept
};

// Whether the vertices of the original that its shape needs may be taken instead of isotropic
// triangles: not if the caller sets sizes, bounds or edges. Of a surface that a lattice has made,
// only on demand. No collapse there looks for crossings: after repair the caller must.
bool mayFollow(const PartOptions& options);

// Throws Error as buildMesh does, and NO_TRIANGLES, INVALID_OPTION, TARGET_TOO_SMALL,
// TARGET_BELOW_CURVES, OUT_OF_MEMORY, CANCELLED.
RemeshOutcome remeshSurface(const TriangleMesh& input, Welding welding, const PartOptions& options,
                            const Progress& progress);
// The same for an input that intersects itself nowhere, without the triangles of its original: what
// intersects itself in the result is mended, as far as possible.
RemeshOutcome remeshUncrossed(const TriangleMesh& input, Welding welding,
                              const PartOptions& options, const Progress& progress);
inline RemeshOutcome remeshSurface(const TriangleMesh& input, const PartOptions& options,
                                   const Progress& progress) {
  requireValid(input);
  return remeshSurface(input, Welding(input), options, progress);
}

}  // namespace remesher
