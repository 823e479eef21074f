// SPDX-License-Identifier: MIT
// Makes one mesh of all that a glTF document shows. Its primitives are those of the meshes, once
// for each place, with their materials.
#pragma once

#include "io/model/model.h"

namespace remesher::io {

// The model, read from glTF, with one part in the world; other nodes stay and show nothing. One
// skin of all meshes stays. The mesh is not animated else: ATTRIBUTE_NOT_CARRIED counts the
// attributes that go.
void uniteGltf(Model& model);

// The same of a model of any format, which keeps nothing but its part.
void uniteParts(Model& model);

}  // namespace remesher::io
