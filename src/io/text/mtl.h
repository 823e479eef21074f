// SPDX-License-Identifier: MIT
// Material libraries of OBJ. They are passed on unchanged. Read are only the names of their images,
// which lie beside them, and the values from which new textures can be painted.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/file.h"
#include "io/model/material.h"

namespace remesher::io {

// The images' names as spelled in the library, each once, in the order of first use.
std::vector<std::string> imagesOf(const File& library);

// The materials by name, in glTF's terms; malformed numbers are ignored. Maps are for texture
// coordinates that begin at the top; their images are named as in the library.
std::map<std::string, Material> materialsOf(const File& library);

}  // namespace remesher::io
