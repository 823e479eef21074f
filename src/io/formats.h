// SPDX-License-Identifier: MIT
// Reads and writes files through the one table of formats: what the bytes of a file are decides how
// it is read, and its name where they leave it open. To add a format, write its pair of functions
// and add a row in formats.cpp.
#pragma once

#include <string>
#include <vector>

#include "base/file.h"
#include "io/model/model.h"
#include "io/model/written_files.h"

namespace remesher::io {

// A name that contradicts the bytes is reported as NAME_CONTRADICTS.
// resources: the files that `file` refers to (a .bin, images, a .mtl), under the names that `file`
// uses. Throws Error: EMPTY_FILE, UNKNOWN_FORMAT, PARSE_ERROR, MISSING_RESOURCE, UNSUPPORTED,
// INDEX_OUT_OF_RANGE, NON_FINITE, NO_TRIANGLES. A scene without triangles is no error: its model
// has no parts and is written as it came.
Model read(const File& file, const std::vector<File>& resources = {});

// Throws Error: UNKNOWN_FORMAT, if `write` does not know the format of this name.
void requireWritable(const std::string& outputName);

enum Holds : unsigned {
  kHoldsScenes = 1,  // instances, places of parts, levels of detail
  kHoldsImages = 2,  // of materials
  kHoldsDoubles = 4,
  kHoldsParts = 8,
  kHoldsMeshes = 16,  // parts with vertices of their own, which no reader joins
  kHoldsTexcoords = 32,
  kHoldsPolygons = 64,
};

// Whether a file of this name can hold that.
bool canHold(const std::string& outputName, Holds what);

// Prepares a model that was read for a file of this name. In a format without instances each shown
// instance becomes a part. In a format with single coordinates the model's are marked as single. If
// single precision would lose a part's shape and the format has instances, the part moves to the
// origin; without instances the warning ROUNDED_FAR_FROM_ORIGIN names the rounding step.
void prepare(Model& model, const std::string& outputName);

// In a format that holds no parts, those of a prepared model become one mesh, without groups, with
// their attributes, except normals and tangents.
void unite(Model& model, const std::string& outputName);

// The parts of a prepared model become one mesh in any format, with their attributes and materials.
void uniteAll(Model& model, const std::string& outputName);

// The format follows the extension of `outputName`, whose last path component names the first file.
// A model written in the format it came from keeps its whole scene; in another format it becomes
// its parts at the places of their instances. Throws Error: UNKNOWN_FORMAT, NO_TRIANGLES.
WrittenFiles write(const Model& model, const std::string& outputName);

// Says how many polygons of the file read were cut into triangles, if the format that is written
// could hold them.
std::vector<Warning> polygonsCut(const Model& model, const WrittenFiles& written);

}  // namespace remesher::io
