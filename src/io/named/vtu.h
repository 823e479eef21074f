// SPDX-License-Identifier: MIT
// VTK's unstructured grids in XML (.vtu). Source: "VTK File Formats", Kitware. Written as text;
// read with arrays as text, inline base64 or appended, without compression. Named sets are the cell
// data `group` (from 0) and the field data `groupNames`.
#pragma once

#include <vector>

#include "base/file.h"
#include "io/model/model.h"
#include "io/model/written_files.h"

namespace remesher::io {

// VTK's types of cells that are faces.
enum VtkFace {
  kVtkTriangle = 5,
  kVtkStrip = 6,
  kVtkPolygon = 7,
  kVtkPixel = 8,
  kVtkQuad = 9,
  kVtkTriangleOfSix = 22,
  kVtkQuadOfEight = 23,
  kVtkQuadOfNine = 28,
};

// Reads triangles, quads, polygons and triangle strips; of faces with nodes on their sides the
// corners. Warns of cells that are no faces. Throws Error: PARSE_ERROR, UNSUPPORTED (compressed
// arrays, big-endian ones), INDEX_OUT_OF_RANGE, NO_TRIANGLES.
Model readVtu(const File& file, const std::vector<File>& resources);
WrittenFiles writeVtu(const Model& model, const std::string& outputName);

}  // namespace remesher::io
