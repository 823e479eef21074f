// SPDX-License-Identifier: MIT
// Gmsh's meshes as text, version 4.1 (read and written) and 2.2 (read). Source: the reference
// manual of Gmsh, "MSH file format". Named sets are physical groups of dimension two.
#pragma once

#include <vector>

#include "base/file.h"
#include "io/model/model.h"
#include "io/model/written_files.h"

namespace remesher::io {

// Reads triangles and quads; of those with nodes on their sides the corners. A face outside of all
// physical groups is in the set of its entity. Warns of elements that are no faces. Throws Error:
// PARSE_ERROR, UNSUPPORTED (binary, other versions), INDEX_OUT_OF_RANGE, NO_TRIANGLES.
Model readGmsh(const File& file, const std::vector<File>& resources);
WrittenFiles writeGmsh(const Model& model, const std::string& outputName);

}  // namespace remesher::io
