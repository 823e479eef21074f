// SPDX-License-Identifier: MIT
// Quads of a surface of several connected parts: each part is made for itself, as if it were alone,
// to its own share of the vertices. A part that needs more than its share gets it from those that
// follow, not by taking quads out of others.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "mesh/mesh_builder.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

// A part of the surface, or several that planes mirror onto each other, as a mesh of its own.
struct SurfacePart {
  TriangleMesh mesh;
  std::vector<Index> vertices;      // per vertex: of the whole
  std::vector<Index> triangles;     // per triangle: of the whole
  std::vector<MirrorPlane> planes;  // of the whole, which may mirror the part onto itself
  double share = 0;                 // of the vertices; of all parts together 1
};

// In the order in which they are to be made: those with the smallest share first, because of larger
// ones a row of quads is a smaller part. Parts without an area are left out. options: their density
// counts, and whether mirror planes are looked for.
std::vector<SurfacePart> surfaceParts(const TriangleMesh& input, const BuiltMesh& built,
                                      const PartOptions& options);

using PartRemesher = std::function<RemeshOutcome(const SurfacePart& part,
                                                 const PartOptions& options, const Progress&)>;

// None if the surface is one connected part. Throws TARGET_TOO_SMALL as targetVertices does, and
// what `remeshPart` throws.
std::optional<RemeshOutcome> remeshPartByPart(const TriangleMesh& input, const Welding& welding,
                                              const PartOptions& options,
                                              const PartRemesher& remeshPart,
                                              const Progress& progress);

}  // namespace remesher
