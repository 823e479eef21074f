// SPDX-License-Identifier: MIT
// The functions that both WebAssembly modules have; the module for arrays has no others. All are
// free functions from plain objects to plain objects; no handle has to be freed.
#include <emscripten/bind.h>

#include "from_js.h"
#include "guarded.h"
#include "remesher.h"
#include "to_js.h"

namespace remesher {
namespace {

using emscripten::val;

// parts: a list of { mesh, places }
val remeshParts(const val& parts, const val& options, const val& onProgress) {
  return guarded([&] {
    const RemeshSceneResult run =
        remeshScene(sceneFrom(parts), optionsFrom(options), progressFrom(onProgress));
    val lods = val::array();
    for (const std::vector<TriangleMesh>& lod : run.lods) lods.call<void>("push", objectFrom(lod));
    val result = val::object();
    result.set("meshes", objectFrom(run.meshes));
    result.set("lods", lods);
    result.set("report", objectFrom(run.report));
    return result;
  });
}

val inspectArrays(const val& mesh) {
  return guarded([&] { return objectFrom(inspect(meshFrom(mesh))); });
}

EMSCRIPTEN_BINDINGS(remesher) {
  emscripten::function("remesh", &remeshParts);
  emscripten::function("inspect", &inspectArrays);
}

}  // namespace
}  // namespace remesher
