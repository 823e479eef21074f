// SPDX-License-Identifier: MIT
// Flattens a scene for formats without scenes: every instance of every part becomes a mesh of its
// own, in world space and under the classic conventions.
#pragma once

#include <vector>

#include "io/model/model.h"

namespace remesher::io {

// Positions that are one place stay one. Normals stay perpendicular to the surface. A mirroring
// transform reverses the triangles, so that outside stays outside.
void transformMesh(TriangleMesh& mesh, const Transform& transform);

// Makes each shown instance a part of its own, except of coarser levels of detail and of instances
// flattened to lines or points. The new part has the old part's name, the identity as its only
// instance, and world coordinates, in double precision unless the instance was the identity.
// HIDDEN_LEFT_OUT counts what is not shown.
void makeBodies(Model& model);

// The same for writing, for every instance of all but coarser levels of detail. Throws NO_TRIANGLES
// if there is nothing to bake.
std::vector<Part> bakeInstances(const Model& model);

// All parts as one mesh; a triangle's group is the number of its part. Attributes that some parts
// lack are filled in there, as appendMesh says, but normals by those of the triangles.
TriangleMesh mergeParts(const std::vector<Part>& parts);

}  // namespace remesher::io
