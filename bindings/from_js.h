// SPDX-License-Identifier: MIT
// Plain JavaScript objects read into plain C++ values. Typed arrays are copied. The package has
// checked names and types (package/api/inputs.js, package/base/options.js).
#pragma once

#include <emscripten/val.h>

#include <vector>

#include "remesher.h"

namespace remesher {

TriangleMesh meshFrom(const emscripten::val& object);
// list: of { mesh, places }, each place a matrix of 16 numbers, column after column.
std::vector<PlacedMesh> sceneFrom(const emscripten::val& list);
FileBundle bundleFrom(const emscripten::val& object);
RemeshOptions optionsFrom(const emscripten::val& object);

// Reads what only the whole engine can do anything with; there it is set.
extern void (*readWholeOptions)(const emscripten::val& object, RemeshOptions& options);

// callback: (phase, fraction) => false to cancel; undefined for none.
Progress progressFrom(const emscripten::val& callback);

}  // namespace remesher
