// SPDX-License-Identifier: MIT
// Textures painted anew. Before remeshing the parts lose what holds their surfaces to the old
// textures; afterwards they get new texture coordinates, normals and tangents, and the model the
// maps that belong to them.
#pragma once

#include <vector>

#include "base/input_place.h"
#include "base/options.h"
#include "base/progress.h"
#include "io/model/model.h"
#include "textures/painting/paint_source.h"

namespace remesher {

class Repaint {
 public:
  Repaint(const io::Model& model, std::vector<io::NamedImage> images);

  // The parts to be remeshed: without textures, colours and normals; groups whose materials can
  // share their maps are one, called by the first of them.
  std::vector<io::Part> bareParts() const;

  // model: its parts remeshed; places: per part and corner. Throws INVALID_OPTION.
  void paint(io::Model& model, const std::vector<std::vector<InputPlace>>& places,
             const RemeshOptions& options, const Progress& progress) const;

 private:
  std::vector<io::Part> originals_;
  std::vector<io::NamedImage> images_;
  Unshaded unshaded_;
  std::size_t classCount_ = 0;
  std::vector<std::vector<Index>> classes_;  // per part and group: who shares maps
};

}  // namespace remesher
