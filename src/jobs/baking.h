// SPDX-License-Identifier: MIT
// Remeshes a model and paints its textures anew.
#pragma once

#include <string>
#include <vector>

#include "base/file.h"
#include "base/part_options.h"
#include "base/progress.h"
#include "io/model/model.h"
#include "jobs/scene_run.h"

namespace remesher {

// The sources of a bake, beside the materials.
struct PaintInput {
  std::vector<io::Part> given;  // the parts as they came, if repair has changed them; else empty
  std::vector<Picture> pictures;
};

// Painted textures need an output format with images: throws UNSUPPORTED.
void requireTextured(const std::string& outputName);

// Remeshes the model's parts and paints textures for them; the model gets their materials. Coarser
// levels of detail follow, simplified from the painted one, with the same maps. Throws
// UNSUPPORTED if the model has nothing to paint from, and MISSING_RESOURCE for an image that its
// materials name and that is not given.
std::vector<SceneRun> remeshBaked(io::Model& model, PaintInput paint, const PartOptions& options,
                                  const Progress& progress);

// Requires all images that the model's materials name; for glTF, the decoder of the images checks
// this. Throws MISSING_RESOURCE.
void requireImages(const io::Model& model, const std::vector<Picture>& pictures);

std::vector<io::NamedImage> imagesFrom(std::vector<Picture> pictures);

// Painted images, as results hand them over.
std::vector<Picture> picturesFrom(std::vector<io::PaintedImage> images);

// Paints textures for the parts as they are, repaired but not remeshed. Throws as above.
void paintRepaired(io::Model& model, PaintInput paint, const PartOptions& options,
                   const Progress& progress);

}  // namespace remesher
