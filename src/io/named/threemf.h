// SPDX-License-Identifier: MIT
// The model inside a 3MF package: its XML, which the caller takes out of the ZIP and puts in.
// Source: 3MF Core Specification 1.3 and Production Extension 1.2. Objects are parts, items of the
// build and components their instances; materials are groups with their names and colours. A file
// is written in the unit that its model has, else in millimetres.
#pragma once

#include <string>
#include <vector>

#include "base/file.h"
#include "io/model/model.h"
#include "io/model/written_files.h"

namespace remesher::io {

// resources: other models of the package that components name by path. Throws Error: PARSE_ERROR,
// INDEX_OUT_OF_RANGE, NO_TRIANGLES.
Model readThreemf(const File& file, const std::vector<File>& resources);
WrittenFiles writeThreemf(const Model& model, const std::string& outputName);

}  // namespace remesher::io
