// SPDX-License-Identifier: MIT
// A mesh that conforms to the original's facets, as a result: with attributes and places.
#pragma once

#include <optional>

#include "remesh/conforming/faceted_mesh.h"
#include "remesh/schemes/follow.h"

namespace remesher {

// A mesh with exactly so many distinct positions, nowhere away from the original, or at about the
// depth where it bends a little. None where that is impossible: see makeConforming.
std::optional<Followed> conformed(const BuiltMesh& original, const TriangleMesh& input,
                                  std::size_t positions, Textures textures,
                                  const FacetLimits& limits = {});

// The fewest positions that keep the shape of a surface whose area is mostly facets of several
// triangles; 0 for others, and where textures or colours are drawn on it.
std::size_t fewestConformed(const TriangleMesh& input);

}  // namespace remesher
