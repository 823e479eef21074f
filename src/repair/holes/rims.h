// SPDX-License-Identifier: MIT
// Which open loops look intended, such as a vase's mouth, mounting holes or the sides of a box
// without a lid: round ones, and straight ones at which walls end. What scanning or cutting has
// torn is ragged, or a cell that lacks its triangles.
#pragma once

#include <optional>

#include "base/report.h"
#include "repair/holes/plug.h"

namespace remesher {

bool looksMeant(const BuiltMesh& built, const Loop& loop);

// Whether the loop lies in a plane in which walls end, as where a tube or a bust is cut off: its
// disk is flat. Where the surface is nearly tangent to the plane, as at a missing patch of a
// sphere, it goes on beyond.
bool looksCutOff(const BuiltMesh& built, const Loop& loop);

// The plane in which walls end at a loop, however few vertices it has: the normal of its lid, and
// the loop's area. None where the loop lies in none, or where the surface is nearly tangent to it.
struct RimPlane {
  SizedPlace place;
  Vec3 normal = Vec3::Zero();
  double area = 0;
};
std::optional<RimPlane> wallPlane(const BuiltMesh& built, const Loop& loop);

// The middle of the loop by length, and twice the largest distance from there.
SizedPlace placeOf(const BuiltMesh& built, const Loop& loop);

}  // namespace remesher
