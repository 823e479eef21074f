// SPDX-License-Identifier: MIT
// STL, binary and text: facets and nothing else. Corners at one place are one vertex. The solids of
// a text are groups of triangles, with their names as materials. The binary kind is written.
#pragma once

#include <string>
#include <vector>

#include "base/file.h"
#include "io/model/model.h"
#include "io/model/written_files.h"

namespace remesher::io {

// Layout of a binary file: a header, the number of facets in 32 bits, the facets.
inline constexpr std::size_t kHeaderBytes = 80, kFacetsAt = 84, kFacetBytes = 50;

Model readStl(const File& file, const std::vector<File>& resources);
WrittenFiles writeStl(const Model& model, const std::string& outputName);

}  // namespace remesher::io
