// SPDX-License-Identifier: MIT
// Repair without a lattice: what is sound stays bit for bit. Vertices are welded, T-junctions
// stitched, loops closed and pieces turned outwards; then bodies that intersect are united exactly.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/triangle_mesh.h"
#include "repair/holes/close_holes.h"
#include "repair/ladder.h"
#include "repair/sheet_bodies.h"

namespace remesher {

struct ExactRepair {
  enum class Way {
    Unchanged,  // the input was sound
    Closed,     // closing and turning made it so
    United,     // bodies were united
    Made,       // bodies were made of sheets
  };
  Way way = Way::Unchanged;
  TriangleMesh mesh;
  std::size_t holes = 0, turned = 0, islands = 0, trianglesRemoved = 0, lines = 0;
  std::size_t backToBack = 0;  // triangles inside that enclosed nothing, gone
  double lost = 0;             // percent of the area: of small open pieces, and at pinches
  std::vector<SizedPlace> closedAt, meantAt, rimsAt;  // of loops, see ClosedHoles
  // Corners of: loops left open, triangles removed, sheets left.
  std::vector<Vec3> openAt, removedAt, sheetsAt;
  std::vector<SizedPlace> hiddenAt;  // the bodies that went
  std::vector<Vec3> filledAt;        // a corner of each cavity filled
  std::vector<SizedPlace> madeAt;    // of sheets that became bodies
  std::vector<Vec3> noBaseAt;        // of sheets that got no base, see SheetBodies
  std::size_t crossingsBefore = 0;   // triangles of the input that intersect others
  std::vector<Index> crossings;      // and of the result
  // What has no exact outside while the rest has: most of it is sheets, or its union would not be
  // sound. Not in `mesh`; without triangles if all is decided.
  TriangleMesh undecided;
  // Per triangle of the result, if bodies were united or a wide loop of a cavity's wall was closed:
  // whether it bounded a cavity before.
  std::vector<char> isOfCavity;
  std::size_t lids = 0;  // the last triangles, which close loops, before bodies are united
};

struct ExactRule {
  LoopRule loops = {kInfinity, ladder::kMostDisk};
  std::optional<BodyRule> bodies = {};  // that are made of what stays open
};

// None where nothing of the surface has an exact outside: where it is sheets, or where no result of
// uniting would be sound. Throws Error as buildMesh does.
std::optional<ExactRepair> exactlyRepaired(const TriangleMesh& input, const ExactRule& rule = {});

// Only closes loops, and turns closed pieces that are inside out. Throws the Errors of closeHoles.
ExactRepair closedOnly(const TriangleMesh& input, const LoopRule& rule);

// Turns closed pieces that are inside out; returns whether there were any. Throws Error as
// buildMesh does.
bool faceOutwards(TriangleMesh& mesh);

// The mesh as it is; its open pieces count as sheets.
ExactRepair leftAlone(const TriangleMesh& input);

// Vertices that count as one get the same coordinates, so that every reader finds them to be one.
TriangleMesh atOnePosition(const TriangleMesh& input);

// Which cavities are filled: all, or only those that uniting bodies has made.
enum class Filled { All, Made };

// Removes the walls of cavities, and the bodies that lie in them.
void fillCavities(ExactRepair& repair, Filled filled);

}  // namespace remesher
