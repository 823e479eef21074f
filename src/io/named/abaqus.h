// SPDX-License-Identifier: MIT
// Abaqus input files, written only: *NODE, and for each named set *ELEMENT with its ELSET, of types
// S3 and S4. Source: Abaqus Keywords Reference Guide, *NODE and *ELEMENT.
#pragma once

#include <string>

#include "io/model/model.h"
#include "io/model/written_files.h"

namespace remesher::io {

WrittenFiles writeAbaqus(const Model& model, const std::string& outputName);

}  // namespace remesher::io
