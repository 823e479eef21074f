// SPDX-License-Identifier: MIT
// Options in percent of the bounding box diagonal that the caller gave as lengths in the world: in
// percent of all parts together, and of each part, whose diagonal in the world is another. And the
// limits of edges that follow from their mean length.
#pragma once

#include <vector>

#include "base/part_options.h"
#include "io/model/model.h"

namespace remesher {

// The diagonal of the box around all parts, each at its largest place; 0 if there is nothing.
// Coarser levels of detail and stray vertices do not count.
double worldDiagonal(const std::vector<io::Part>& parts);

// How many times as long a length in the part's own space is in the world.
double growthOf(const Transform& toWorld);

// The options with their lengths in percent of such a diagonal as well.
PartOptions withPercents(PartOptions options, double diagonal);
PartOptions withPercents(const RemeshOptions& asked, const std::vector<io::Part>& parts);

// A mean length of edges together with a smallest angle, as solvers want them, limits each edge as
// well: to a length from 0.4 to 2 times the mean, unless the caller sets limits. An error bound may
// need shorter edges.
void limitEdges(PartOptions& options);

// What options of a part are percent of: the part's own diagonal.
PartOptions withPercentsOf(const TriangleMesh& mesh, double growth, PartOptions options);

}  // namespace remesher
