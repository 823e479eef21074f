// SPDX-License-Identifier: MIT
// The thresholds of `repair: auto`, in the order of its steps: each step changes more than the one
// before, and is taken where the one before does not apply.
#pragma once

namespace remesher::ladder {

// 1. Exact repair does not apply to a surface with more than kMostSheets of its area in sheets, or
// whose union keeps more than kMostCrossingsLeft of the self-intersections that there were.
// An open piece is a sheet if disks over its loops have more than kMostDisk of its area: half a
// sphere has 1/2, a flat card 1.
inline constexpr double kMostDisk = 0.6;  // ratio of areas
// Where sheets become bodies a bowl is a sheet, too, and a small hole in one is still closed.
inline constexpr double kMostDiskOfBody = 0.05;     // ratio of areas
inline constexpr double kMostSheets = 0.3;          // ratio of areas
inline constexpr double kMostCrossingsLeft = 0.05;  // ratio of triangles
// Nor to one of which closing loops would remove more than kMostRemoved, as of loose triangles.
inline constexpr double kMostRemoved = 20;  // percent of the area

// 2. The lattice's bodies are taken if nearly all half lines agree which points are inside, and
// hardly any visible surface is lost.
inline constexpr double kMostUnsure = 0.1;  // ratio of the points beside the surface
inline constexpr double kMostLost = 3;      // percent of the lines of sight

// 3. Sheets stay as they are if hardly anything else is there, and few of them intersect.
inline constexpr double kNearlyAllSheets = 0.9;    // ratio of areas
inline constexpr double kMostSheetsCrossed = 0.5;  // ratio of triangles

// 4. Everything else is wrapped.

}  // namespace remesher::ladder
