// SPDX-License-Identifier: MIT
// Plain C++ values written into plain JavaScript objects. Typed arrays are copies: nothing in
// JavaScript points into this memory.
#pragma once

#include <emscripten/val.h>

#include <vector>

#include "remesher.h"

namespace remesher {

template <class T>
emscripten::val arrayFrom(const std::vector<T>& values) {
  const auto view = emscripten::typed_memory_view(values.size(), values.data());
  return emscripten::val(view).template call<emscripten::val>("slice");
}

emscripten::val objectFrom(const TriangleMesh& mesh);
emscripten::val objectFrom(const std::vector<TriangleMesh>& meshes);
emscripten::val objectFrom(const std::vector<File>& files);
emscripten::val objectFrom(const std::vector<Picture>& pictures);
emscripten::val objectFrom(const std::vector<Warning>& warnings);
emscripten::val objectFrom(const Report& report);

// Writes what only the whole engine reports; there it is set.
extern emscripten::val (*repairInJs)(const RepairReport& repair);
extern emscripten::val (*droppedInJs)(const DropReport& dropped);
extern emscripten::val (*atlasInJs)(const AtlasReport& atlas);
extern emscripten::val (*wantedInJs)(const WantedReport& wanted);
extern emscripten::val (*conformInJs)(const ConformReport& conform);

}  // namespace remesher
