// SPDX-License-Identifier: MIT
// STL, facets and nothing else, binary and as text. Corners at one place are one vertex; the solids
// of a text are groups of triangles, their names those of materials. Written is the binary kind.
#pragma once

#include <string>
#include <vector>

#include "base/file.h"
#include "io/model/model.h"
#include "io/model/written_files.h"

namespace remesher::io {

// Of a binary file: a header, how many facets there are in 32 bits, the facets.
inline constexpr std::size_t kHeaderBytes = 80, kFacetsAt = 84, kFacetBytes = 50;

Model readStl(const File& file, const std::vector<File>& resources);
WrittenFiles writeStl(const Model& model, const std::string& outputName);

}  // namespace remesher::io
