// SPDX-License-Identifier: MIT
// Material libraries of OBJ. They are passed on as they come; what is read of them is the names of
// their images, which lie beside them, and what new textures can be painted from.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/file.h"
#include "io/model/material.h"

namespace remesher::io {

// As the library spells them, each once, in the order of their first use.
std::vector<std::string> imagesOf(const File& library);

// The materials by their names, as glTF would say them; what has no number where one should be says
// nothing. Maps are for texture coordinates that begin at the top;
// their images are called as the library spells them.
std::map<std::string, Material> materialsOf(const File& library);

}  // namespace remesher::io
