// SPDX-License-Identifier: MIT
#include "jobs/baking.h"

#include <algorithm>
#include <utility>

#include "base/legible.h"
#include "io/formats.h"
#include "jobs/part_run.h"
#include "jobs/run_guards.h"
#include "textures/repaint.h"

namespace remesher {

namespace {

// The approximate shares of a run's time.
constexpr double kPaintShare = 0.4, kLevelsShare = 0.1;

// Materials are read only from glTF and OBJ; colors of vertices from other formats, too.
void requirePaint(const io::Model& model) {
  const auto isPaint = [](const io::Part& part) {
    const auto& groups = part.groups;
    return findAttribute(part.mesh, "COLOR_0") != nullptr ||
           std::any_of(groups.begin(), groups.end(),
                       [](const io::GroupInfo& group) { return !group.look.name.empty(); });
  };
  if (model.conventions == io::Conventions::Gltf) return;
  if (std::all_of(model.parts.begin(), model.parts.end(), isPaint)) return;
  throw Error(ErrorCode::Unsupported,
              "Textures are painted from glTF files, from the materials of OBJ and from colours of "
              "vertices, and this has none.",
              "Give an OBJ with its material library, or convert it to .glb with its textures.");
}

Repaint repaintOf(io::Model& model, PaintInput paint) {
  requirePaint(model);
  requireImages(model, paint.pictures);
  std::erase_if(model.warnings,
                [](const Warning& w) { return w.code == "MATERIAL_IMAGES_NOT_READ"; });
  return Repaint(model, std::move(paint.given), imagesFrom(std::move(paint.pictures)));
}

}  // namespace

void requireImages(const io::Model& model, const std::vector<Picture>& pictures) {
  if (model.conventions == io::Conventions::Gltf) return;
  const auto require = [&](const io::Map& map) {
    const auto isIt = [&](const Picture& picture) { return picture.name == map.image; };
    if (!map || std::any_of(pictures.begin(), pictures.end(), isIt)) return;
    throw Error(ErrorCode::MissingResource, "The image " + legible(map.image) + " was not given.",
                "Give the image with the file, or keep the textures.");
  };
  for (const io::Part& part : model.parts)
    for (const io::GroupInfo& group : part.groups)
      for (const io::Map* map :
           {&group.look.baseColorMap, &group.look.emissiveMap, &group.look.normalMap})
        require(*map);
}

std::vector<io::NamedImage> imagesFrom(std::vector<Picture> pictures) {
  std::vector<io::NamedImage> images;
  for (Picture& picture : pictures)
    images.push_back(
        {std::move(picture.name), {picture.width, picture.height, std::move(picture.texels)}});
  return images;
}

void requireTextured(const std::string& outputName) {
  if (io::canHold(outputName, io::kHoldsImages)) return;
  throw Error(ErrorCode::Unsupported,
              "Baked textures are written as glTF only, not as " + legible(outputName) + ".",
              "Let the output's name end in .glb or .gltf.");
}

std::vector<SceneRun> remeshBaked(io::Model& model, PaintInput paint, const PartOptions& options,
                                  const Progress& progress) {
  const Repaint repaint = repaintOf(model, std::move(paint));
  const std::vector<io::Part> bare = repaint.bareParts();
  const double painted = options.lods.empty() ? 1 : 1 - kLevelsShare;
  SceneRun run = remeshParts(bare, options, progress.part(0, 1 - kPaintShare));
  model.parts = std::move(run.parts);
  withinMemory([&] {
    repaint.paint(model, run.places, options, progress.phase("paint", 1 - kPaintShare, painted));
  });
  run.parts = std::move(model.parts);
  std::vector<SceneRun> levels = simplifiedLevels(bare, run, options, progress.part(painted, 1));
  for (const SceneRun& level : levels) run.report.lods.push_back(level.report);
  levels.insert(levels.begin(), std::move(run));
  return levels;
}

std::vector<Picture> picturesFrom(std::vector<io::PaintedImage> images) {
  std::vector<Picture> pictures;
  for (io::PaintedImage& image : images)
    pictures.push_back({std::move(image.name), std::move(image.type), image.image.width,
                        image.image.height, std::move(image.image.texels)});
  return pictures;
}

void paintRepaired(io::Model& model, PaintInput paint, const PartOptions& options,
                   const Progress& progress) {
  const Repaint repaint = repaintOf(model, std::move(paint));
  model.parts = repaint.bareParts();
  std::vector<std::vector<InputPlace>> places;
  for (const io::Part& part : model.parts) places.push_back(ownPlaces(part.mesh));
  withinMemory([&] { repaint.paint(model, places, options, progress.phase("paint", 0, 1)); });
}

}  // namespace remesher
