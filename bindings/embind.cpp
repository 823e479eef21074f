// SPDX-License-Identifier: MIT
// The WebAssembly module: free functions from plain objects to plain objects; no handle has to be
// freed. Every failure comes back as { error: { code, message, hint } }.
#include <emscripten/bind.h>

#include <new>
#include <stdexcept>

#include "from_js.h"
#include "remesher.h"
#include "to_js.h"

namespace remesher {
namespace {

using emscripten::val;

val failure(ErrorCode code, const std::string& message, const std::string& hint) {
  val error = val::object();
  error.set("code", std::string(name(code)));
  error.set("message", message);
  error.set("hint", hint);
  val result = val::object();
  result.set("error", error);
  return result;
}

template <class Body>
val guarded(Body body) {
  try {
    return body();
  } catch (const Error& error) {
    return failure(error.code, error.what(), error.hint);
  } catch (const std::bad_alloc&) {
    return failure(ErrorCode::OutOfMemory, "The run needs more memory than WebAssembly can have.",
                   "Ask for fewer vertices, or give the model in parts.");
  } catch (const std::exception& error) {
    return failure(ErrorCode::Internal, error.what(), "Please report this as a bug.");
  }
}

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

// request: { name, bytes, resources, output }
val remeshBytes(const val& request, const val& options, const val& onProgress) {
  return guarded([&] {
    const RemeshFileResult run =
        remeshFile(bundleFrom(request), request["output"].as<std::string>(), optionsFrom(options),
                   progressFrom(onProgress));
    val result = val::object();
    result.set("files", objectFrom(run.files));
    if (!run.pictures.empty()) result.set("pictures", objectFrom(run.pictures));
    result.set("report", objectFrom(run.report));
    return result;
  });
}

val repairArrays(const val& mesh, const val& options, const val& onProgress) {
  return guarded([&] {
    const RepairResult run = repair(meshFrom(mesh), optionsFrom(options), progressFrom(onProgress));
    val result = val::object();
    result.set("meshes", objectFrom(std::vector<TriangleMesh>{run.mesh}));
    result.set("report", objectFrom(run.report));
    return result;
  });
}

// request: { name, bytes, resources, output }
val repairBytes(const val& request, const val& options, const val& onProgress) {
  return guarded([&] {
    const RemeshFileResult run =
        repairFile(bundleFrom(request), request["output"].as<std::string>(), optionsFrom(options),
                   progressFrom(onProgress));
    val result = val::object();
    result.set("files", objectFrom(run.files));
    result.set("report", objectFrom(run.report));
    return result;
  });
}

// request: { name, bytes, resources, output }
val convertBytes(const val& request) {
  return guarded([&] {
    const ConvertFileResult run =
        convertFile(bundleFrom(request), request["output"].as<std::string>());
    val result = val::object();
    result.set("files", objectFrom(run.files));
    result.set("warnings", objectFrom(run.warnings));
    return result;
  });
}

val inspectArrays(const val& mesh) {
  return guarded([&] { return objectFrom(inspect(meshFrom(mesh))); });
}

// request: { name, bytes, resources }
val inspectBytes(const val& request) {
  return guarded([&] { return objectFrom(inspectFile(bundleFrom(request))); });
}

// For the tests that hold the lists of both languages together.
val errorCodes() {
  val result = val::array();
  for (std::string_view code : kErrorCodeNames) result.call<void>("push", std::string(code));
  return result;
}

val defaultOptions() { return objectFrom(RemeshOptions()); }

EMSCRIPTEN_BINDINGS(remesher) {
  emscripten::function("remesh", &remeshParts);
  emscripten::function("remeshFile", &remeshBytes);
  emscripten::function("repair", &repairArrays);
  emscripten::function("repairFile", &repairBytes);
  emscripten::function("convertFile", &convertBytes);
  emscripten::function("inspect", &inspectArrays);
  emscripten::function("inspectFile", &inspectBytes);
  emscripten::function("errorCodes", &errorCodes);
  emscripten::function("defaultOptions", &defaultOptions);
}

}  // namespace
}  // namespace remesher
