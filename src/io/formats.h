// SPDX-License-Identifier: MIT
// Files in, files out: the one table of formats, by extension and by first bytes. To add a format,
// write its pair of functions and add a row in formats.cpp.
#pragma once

#include <string>
#include <vector>

#include "base/file.h"
#include "io/model/model.h"
#include "io/model/written_files.h"

namespace remesher::io {

// resources: the files that `file` refers to (a .bin, images, a .mtl), by the names it uses for
// them. Throws Error: EMPTY_FILE, UNKNOWN_FORMAT, PARSE_ERROR, MISSING_RESOURCE, UNSUPPORTED,
// INDEX_OUT_OF_RANGE, NON_FINITE, NO_TRIANGLES. A scene without triangles is no error: its model
// has no parts, and is written as it came.
Model read(const File& file, const std::vector<File>& resources = {});

// Throws Error: UNKNOWN_FORMAT, unless `write` knows the format of such a name.
void requireWritable(const std::string& outputName);

// Whether a file of such a name can hold the levels of detail of its parts.
bool holdsLods(const std::string& outputName);

// Whether it can hold the images of materials.
bool holdsImages(const std::string& outputName);

// Readies a model that was read for a file of such a name: where there are no instances, each that
// is shown becomes a part; its coordinates are said to be single where those there are; where that
// would cost its shape, and the file says where its parts are, each moves to the origin.
void prepare(Model& model, const std::string& outputName);

// The format follows the extension of `outputName`, whose last part names the first file. Into the
// format it came from, a model takes
// its whole scene along; into another, its parts where their instances are.
// Throws Error: UNKNOWN_FORMAT, NO_TRIANGLES.
WrittenFiles write(const Model& model, const std::string& outputName);

}  // namespace remesher::io
