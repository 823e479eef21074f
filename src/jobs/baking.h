// SPDX-License-Identifier: MIT
// Remeshes a model and paints its textures anew.
#pragma once

#include <string>
#include <vector>

#include "base/file.h"
#include "base/options.h"
#include "base/progress.h"
#include "io/model/model.h"
#include "jobs/scene_run.h"

namespace remesher {

// Painted textures need an output format with images: throws UNSUPPORTED.
void requireTextured(const std::string& outputName);

// Remeshes the model's parts and paints textures for them; the model gets their materials. Throws
// UNSUPPORTED if the model has nothing to paint from, and MISSING_RESOURCE for an image that its
// materials name and that is not given.
SceneRun remeshBaked(io::Model& model, std::vector<Picture> pictures, const RemeshOptions& options,
                     const Progress& progress);

// Painted images, as results hand them over.
std::vector<Picture> picturesFrom(std::vector<io::PaintedImage> images);

// Paints textures for the parts as they are, repaired but not remeshed. Throws as above.
void paintRepaired(io::Model& model, std::vector<Picture> pictures, const RemeshOptions& options,
                   const Progress& progress);

}  // namespace remesher
