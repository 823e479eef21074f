// SPDX-License-Identifier: MIT
// glTF 2.0, as text (.gltf) and binary (.glb). Every mesh with triangles is a part. The rest of the
// document is kept as parsed; writing changes only the accessors of replaced triangles.
#pragma once

#include <string>
#include <vector>

#include "base/file.h"
#include "io/model/model.h"
#include "io/model/written_files.h"

namespace remesher::io {

Model readGltf(const File& file, const std::vector<File>& resources);
WrittenFiles writeGltf(const Model& model, const std::string& outputName);
WrittenFiles writeGlb(const Model& model, const std::string& outputName);

}  // namespace remesher::io
