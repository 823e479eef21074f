// SPDX-License-Identifier: MIT
// Wavefront OBJ. Reads v (with colours as x y z r g b), vt, vn, f with polygons of any size and
// negative numbers, o, g, s, usemtl, mtllib. Writes the same statements, and passes the material
// library on unchanged.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "base/file.h"
#include "io/model/model.h"
#include "io/model/written_files.h"

namespace remesher::io {

Model readObj(const File& file, const std::vector<File>& resources);
WrittenFiles writeObj(const Model& model, const std::string& outputName);

// The state in which a run of faces was read. A triangle's group number is an index into
// ObjSource::groups.
struct ObjGroup {
  std::string object;
  std::string groups;
  std::string smoothing;
  std::string material;
  bool hasTexcoords = false;
  bool hasNormals = false;

  auto members() const {
    return std::tie(object, groups, smoothing, material, hasTexcoords, hasNormals);
  }
  bool operator==(const ObjGroup&) const = default;
  bool operator<(const ObjGroup& other) const { return members() < other.members(); }
};

struct ObjSource : Source {
  std::vector<ObjGroup> groups;
  std::vector<std::string> libraries;  // the names behind mtllib
  std::vector<File> libraryFiles;      // the libraries that were given
};

}  // namespace remesher::io
