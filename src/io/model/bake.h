// SPDX-License-Identifier: MIT
// A scene flattened for formats that know no scene: every instance of every part as a mesh of its
// own, in world space and under the classic conventions.
#pragma once

#include <vector>

#include "io/model/model.h"

namespace remesher::io {

// Normals stay perpendicular, and a mirroring transform turns the triangles around, so that outside
// stays outside.
void transformMesh(TriangleMesh& mesh, const Transform& transform);

// Makes the parts one per instance that is shown and at which anything is to be seen, but for
// coarser levels of detail, its only instance the identity; named as the part it came from. Its
// coordinates are those of the world, in double precision. HIDDEN_LEFT_OUT says what is not shown.
void makeBodies(Model& model);

// The same for writing. One part per instance, but for coarser levels of detail, its only instance
// the identity; named as the part it came from. Throws NO_TRIANGLES when there is nothing to bake.
std::vector<Part> bakeInstances(const Model& model);

// All parts as one mesh; the group of a triangle is the number of its part. Attributes that not
// all parts have are left out.
TriangleMesh mergeParts(const std::vector<Part>& parts);

}  // namespace remesher::io
