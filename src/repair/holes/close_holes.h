// SPDX-License-Identifier: MIT
// Closes the open loops of a surface. The rest stays the same, bit for bit.
#pragma once

#include <vector>

#include "base/report.h"
#include "base/triangle_mesh.h"
#include "repair/holes/kept_surface.h"

namespace remesher {

// Which loops are closed.
struct LoopRule {
  double longest = kInfinity;  // a length; longer loops stay open
  // A component whose disks would have more than this share of its own area is a sheet, such as a
  // card or a terrain: its loops stay open.
  double mostDisk = kInfinity;
  bool keepsRims = false;  // loops that look intended stay open
  // Sheets are wanted, as they are or as bodies afterwards: their small loops that do not look
  // meant are closed, and open components stay, however small.
  bool keepsSheets = false;
};

struct ClosedHoles {
  TriangleMesh mesh;                 // vertices: all given, then new; triangles: kept, then disks
  std::vector<InputTriangle> kept;   // per triangle that is in no disk the input's, ascending
  std::size_t holes = 0;             // loops closed
  std::vector<SizedPlace> closedAt;  // each of them
  std::vector<SizedPlace> meantAt;   // those of them that look intended
  std::vector<SizedPlace> rimsAt;    // loops left open because they look intended
  std::vector<Vec3> openAt;          // a vertex of each loop too long to be closed
  std::vector<Vec3> sheetsAt;        // a vertex of each sheet
  double sheetArea = 0;              // of all sheets
  std::size_t islands = 0;           // small open components removed
  std::vector<Vec3> removedAt;       // a corner of each of them, and of what goes at pinches
  std::size_t trianglesRemoved = 0;  // of debris, at pinches, or given twice
  std::size_t lines = 0;             // without three distinct corners, removed
};

// Each loop that the rule does not leave open gets a disk, so that its edges have two triangles. A
// disk intersects the surface only if each of its three shapes does (smooth, flat, without new
// vertices). Throws the Errors of keptSurface.
ClosedHoles closeHoles(const TriangleMesh& input, const LoopRule& rule = {});

}  // namespace remesher
