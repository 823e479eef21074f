// SPDX-License-Identifier: MIT
// Measures the parts of a file together, for the report.
#pragma once

#include <optional>
#include <vector>

#include "base/report.h"
#include "geometry/triangle_tree.h"
#include "io/model/model.h"
#include "jobs/parts/part_places.h"
#include "measure/hausdorff.h"
#include "mesh/welding.h"

namespace remesher {

// How a file holds parts: each by itself, or all as one surface, which a reader joins wherever
// vertices have the same position.
enum class Held { Apart, AsOne };

// The parts as a reader finds them in the file. Parts held as one are in the world already.
std::vector<io::Part> asHeld(const std::vector<io::Part>& parts, Held held);

// Throws the Errors of requireValid.
std::vector<Welding> weldingsOf(const std::vector<io::Part>& parts);

// Measures each part as it looks at its place, except coarser levels of detail. Counts add up;
// shares and means are weighted by the counts that they refer to.
MeshReport inspectParts(const std::vector<io::Part>& parts, const std::vector<Welding>& weldings,
                        const std::vector<PartPlace>& places);

// All parts at their places, relative to the first place, as one set of triangles without those
// that are lines.
TriangleMesh gathered(const std::vector<io::Part>& parts, const std::vector<PartPlace>& places);

// The given parts, one at least, and the results made of them.
struct PartPairs {
  const std::vector<io::Part>& originals;
  const std::vector<io::Part>& results;
  const std::vector<PartPlace>& places;
};

// The distances of the gathered results from the gathered originals, or what other places of a part
// may make of its own: an upper bound. tree: if at hand, of the only part's triangles, each once
// and without lines.
FidelityReport fidelityOf(const PartPairs& parts, Maximum maximum, std::optional<ListedTree> tree);

// Both lists as one. Of several warnings with one code the first's message and place stay, with the
// sum of their counts.
std::vector<Warning> mergedByCode(std::vector<Warning> all, const std::vector<Warning>& more);

}  // namespace remesher
