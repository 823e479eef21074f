// SPDX-License-Identifier: MIT
#include "jobs/level_files.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/legible.h"
#include "io/model/levels.h"
#include "jobs/level_switches.h"
#include "jobs/parts/part_report.h"

namespace remesher {

namespace {

// By level whether a part of it has fewer triangles than that part has in each finer level.
std::vector<char> areCoarser(const std::vector<SceneRun>& runs) {
  std::vector<char> result(runs.size(), 0);
  for (std::size_t i = 0; i < runs.front().parts.size(); ++i) {
    std::size_t least = runs.front().parts[i].mesh.triangleCount();
    for (std::size_t level = 1; level < runs.size(); ++level) {
      const std::size_t count = runs[level].parts[i].mesh.triangleCount();
      if (count < least) result[level] = 1;
      least = std::min(least, count);
    }
  }
  return result;
}

// LEVEL_NOT_COARSER, if levels are left out of the file.
std::vector<Warning> levelsLeftOut(const std::vector<SceneRun>& runs) {
  const std::vector<char> isCoarser = areCoarser(runs);
  std::string numbers;
  std::size_t count = 0;
  for (std::size_t level = 1; level < runs.size(); ++level)
    if (!isCoarser[level]) numbers += (count++ > 0 ? ", " : "") + std::to_string(level);
  if (count == 0) return {};
  const std::string words =
      count == 1
          ? "Level of detail " + numbers + " has no fewer triangles than those before it, and is "
          : "Levels of detail " + numbers +
                " have no fewer triangles than those before them, and are ";
  return {{"LEVEL_NOT_COARSER", words + "not in the file.", count}};
}

// Gives a part its levels, finest first. One that is no coarser than that before it is left out:
// the one before is shown until the next takes over.
void addLods(io::Part& part, std::vector<TriangleMesh> levels) {
  std::vector<double> coverages;
  std::size_t least = part.mesh.triangleCount();
  for (std::size_t k = 0; k < levels.size(); ++k) {
    if (levels[k].triangleCount() >= least) continue;
    least = levels[k].triangleCount();
    if (k < part.coverages.size()) coverages.push_back(part.coverages[k]);
    part.lods.push_back(std::move(levels[k]));
  }
  part.coverages = std::move(coverages);
}

// The model with the finest level as its parts, which hold the coarser ones.
io::Model withLods(io::Model model, std::vector<SceneRun>& runs) {
  model.parts = std::move(runs.front().parts);
  setCoverages(model.parts, runs.front().report);
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    std::vector<TriangleMesh> levels;
    for (std::size_t level = 1; level < runs.size(); ++level)
      levels.push_back(std::move(runs[level].parts[i].mesh));
    addLods(model.parts[i], std::move(levels));
  }
  return model;
}

// Writes a file for each level. Files beside them, such as textures, are written once.
io::WrittenFiles writeEach(io::Model model, std::vector<SceneRun>& runs,
                           const std::string& outputName) {
  io::WrittenFiles all;
  std::set<std::string> names;
  for (std::size_t level = 0; level < runs.size(); ++level) {
    model.parts = std::move(runs[level].parts);
    io::WrittenFiles written = io::write(model, io::nameOfLevel(outputName, level));
    for (File& file : written.files)
      if (names.insert(file.name).second) all.files.push_back(std::move(file));
    all.warnings = mergedByCode(std::move(all.warnings), written.warnings);
    all.images = std::move(written.images);  // the same for every level
  }
  return all;
}

}  // namespace

void requireRoomForLevels(const std::string& outputName, const RemeshOptions& options) {
  if (options.lods.empty() || options.lodFiles || io::canHold(outputName, io::kHoldsScenes)) return;
  throw Error(ErrorCode::InvalidOption, legible(outputName) + " cannot hold levels of detail.",
              "Name the output .glb or .gltf, or ask for a file each: --lod-files.");
}

io::WrittenFiles writeLevels(io::Model model, std::vector<SceneRun>& runs,
                             const std::string& outputName, const RemeshOptions& options) {
  if (options.lodFiles) return writeEach(std::move(model), runs, outputName);
  std::vector<Warning> warnings = levelsLeftOut(runs);
  io::WrittenFiles written = io::write(withLods(std::move(model), runs), outputName);
  written.warnings = mergedByCode(std::move(warnings), written.warnings);
  return written;
}

}  // namespace remesher
