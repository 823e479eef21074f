// SPDX-License-Identifier: MIT
// Paints one surface onto another mesh, which stays as it is.
#pragma once

#include <vector>

#include "base/options.h"
#include "base/progress.h"
#include "base/report.h"
#include "io/model/model.h"
#include "textures/painting/paint_source.h"

namespace remesher {

// The sources of a bake, under the conventions of glTF.
struct BakeOriginals {
  std::vector<io::Part> originals;  // the same surface in the spaces of several parts
  std::vector<Index> originalOf;    // per part to paint the number of its original
  std::vector<io::NamedImage> images;
  Unshaded unshaded;
};

// Paints one set of maps for all parts of the model, which is under the conventions of glTF. Adds
// warnings to it. The parts' texture coordinates are used if they can be, else they get new ones.
// Throws INVALID_OPTION.
AtlasReport bakeOnto(io::Model& model, const BakeOriginals& from, const RemeshOptions& options,
                     const Progress& progress);

}  // namespace remesher
