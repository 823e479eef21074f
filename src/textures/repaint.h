// SPDX-License-Identifier: MIT
// Paints textures anew. Before remeshing, parts lose all attributes that tie their surfaces to the
// old textures. Afterwards parts get new texture coordinates, normals and tangents, and the model
// gets the maps for them.
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
  // given: the parts as they came, to paint from, if repair has changed the model's; else empty.
  Repaint(const io::Model& model, std::vector<io::Part> given, std::vector<io::NamedImage> images);

  // The parts to be remeshed, without textures, colours and normals. Groups whose materials can
  // share their maps become one group, with the number of the first.
  std::vector<io::Part> bareParts() const;

  // model: with its parts remeshed; places: per part and corner. Throws INVALID_OPTION.
  void paint(io::Model& model, const std::vector<std::vector<InputPlace>>& places,
             const RemeshOptions& options, const Progress& progress) const;

 private:
  std::vector<io::Part> surfaces_;   // to be remeshed
  std::vector<io::Part> originals_;  // to paint from
  std::vector<io::NamedImage> images_;
  Unshaded unshaded_;
  std::size_t classCount_ = 0;
  std::vector<std::vector<Index>> classes_;  // per part and group: the number of its shared maps
};

}  // namespace remesher
