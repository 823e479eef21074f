// SPDX-License-Identifier: MIT
// The other way to few vertices: not even triangles, but those vertices of the original that its
// shape needs most. What was modelled by hand has bevels and tubes thinner than an even triangle of
// the result, and is lost in that.
#pragma once

#include <optional>

#include "gate/fidelity.h"
#include "surface/original_surface.h"

namespace remesher {

// How many different places the vertices have: fewer than there are vertices where the builder cut
// the input apart.
std::size_t distinctPositions(const WorkingMesh& mesh);

// With exactly so many distinct positions; none where the original has no more, so many more that
// its triangles are not what it shows, or where nothing else goes.
std::optional<WorkingMesh> follow(const OriginalSurface& surface, const FidelityRule& rule,
                                  std::size_t positions);

// Whether the even mesh is visibly away from the original, and the other much nearer.
bool isMuchNearer(const OriginalSurface& surface, const WorkingMesh& other,
                  const WorkingMesh& even);

}  // namespace remesher
