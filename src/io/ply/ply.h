// SPDX-License-Identifier: MIT
// PLY, the Stanford Polygon format, as text and in both byte orders. Reads vertices with all their
// properties (see ply_layout.h), faces of any size, triangle strips, and MeshLab's texture
// coordinates per face corner. An unchanged mesh is written as it came; a new mesh in the same
// encoding, with the same properties in the same types.
#pragma once

#include <string>
#include <vector>

#include "base/file.h"
#include "io/model/model.h"
#include "io/model/written_files.h"
#include "io/ply/ply_layout.h"

namespace remesher::io {

// A file with a source is binary, and its header ends within its first bytes.
inline constexpr std::size_t kHeaderLooked = 65536;

Model readPly(const File& file, const std::vector<File>& resources);
WrittenFiles writePly(const Model& model, const std::string& outputName);

// Whether a model of another format will be written in single precision. One that was read from PLY
// is written in its own.
bool becomesSingle(const Model& model);

struct PlySource : Source {
  File original;
  PlyHeader header;
  std::vector<PlyField> fields;  // of the vertices
  bool hasCornerTexcoords = false;
  std::vector<double> textureNumbers;  // the texnumber of each group of triangles; may be empty
  std::size_t vertexCount = 0;         // of the mesh that was read
  std::size_t triangleCount = 0;
};

}  // namespace remesher::io
