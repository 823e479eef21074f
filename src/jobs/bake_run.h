// SPDX-License-Identifier: MIT
// Bakes one model onto another, and gives a model new texture coordinates.
#pragma once

#include <vector>

#include "base/file.h"
#include "base/options.h"
#include "base/progress.h"
#include "base/report.h"
#include "base/room.h"
#include "io/model/model.h"

namespace remesher {

// The model to paint from, with its decoded images.
struct BakeSource {
  io::Model model;
  std::vector<Picture> pictures;
};

// Paints all that the high model shows onto the low one, which gets materials, maps and texture
// coordinates, and is under the conventions of glTF afterwards. The report is on the low model,
// without distances. Throws INVALID_OPTION, MISSING_RESOURCE, and the Errors of requireValid.
Report runBake(BakeSource high, io::Model& low, const RemeshOptions& options,
               const Progress& progress);

// Throws OUT_OF_MEMORY if the parts have no room to be unwrapped.
void requireRoomToUnwrap(const std::vector<io::Part>& parts, double addresses = kAddresses);

// Gives all parts of the model together new texture coordinates; images of its materials, which no
// longer fit, are left out. Throws INVALID_OPTION, the Errors of requireValid, and those above.
Report runUnwrap(io::Model& model, const RemeshOptions& options, const Progress& progress);

}  // namespace remesher
