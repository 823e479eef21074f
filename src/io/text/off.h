// SPDX-License-Identifier: MIT
// The Object File Format, OFF: counts, vertices, polygons. Normals (NOFF), texture coordinates
// (STOFF) and vertex colours (COFF) are kept; colours of faces are not.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"
#include "io/model/model.h"
#include "io/model/written_files.h"

namespace remesher::io {

// Whether the text begins with OFF's keyword, which files may lack.
bool beginsAsOff(std::string_view text);

Model readOff(const File& file, const std::vector<File>& resources);
WrittenFiles writeOff(const Model& model, const std::string& outputName);

}  // namespace remesher::io
