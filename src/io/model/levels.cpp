// SPDX-License-Identifier: MIT
#include "io/model/levels.h"

#include <utility>

namespace remesher::io {

void replaceLevels(Model& model) {
  std::size_t levels = 0;
  for (const Part& part : model.parts)
    if (!part.finer.empty()) ++levels;
  if (levels == 0) return;
  std::vector<Part> finest;
  for (Part& part : model.parts)
    if (part.finer.empty()) finest.push_back(std::move(part));
  model.parts = std::move(finest);
  model.replacesLevels = true;
  model.warnings.push_back({"LEVELS_REPLACED",
                            "Coarser levels of detail that the file has are replaced by those "
                            "asked for.",
                            levels});
}

std::string nameOfLevel(const std::string& fileName, std::size_t level) {
  if (level == 0) return fileName;
  return std::string(fileName).insert(fileName.rfind('.'), "_lod" + std::to_string(level));
}

}  // namespace remesher::io
