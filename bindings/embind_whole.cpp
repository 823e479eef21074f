// SPDX-License-Identifier: MIT
// The further functions of the whole WebAssembly module: repair and files. Code that is reached
// only from here, such as readers and writers, is not linked into the other module.
#include <emscripten/bind.h>

#include "choice_names.h"
#include "from_js.h"
#include "guarded.h"
#include "remesher.h"
#include "to_js.h"

namespace remesher {
namespace {

using emscripten::val;

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

val faultsFrom(const FaultReport& faults) {
  val result = val::object(), loops = val::array();
  for (const double length : faults.openLoops) loops.call<void>("push", length);
  result.set("openLoops", loops);
  result.set("selfIntersections", double(faults.selfIntersections));
  result.set("innerShells", double(faults.innerShells));
  result.set("insideOut", double(faults.insideOut));
  result.set("repair", std::string(nameOf(kRepairs, faults.repair)));
  return result;
}

val inspectClosely(const val& mesh) {
  return guarded([&] {
    const TriangleMesh given = meshFrom(mesh);
    val result = objectFrom(inspect(given));
    result.set("faults", faultsFrom(findFaults(given)));
    return result;
  });
}

// request: { name, bytes, resources }
val inspectBytes(const val& request, bool areFaultsSought) {
  return guarded([&] {
    const FileBundle bundle = bundleFrom(request);
    val result = objectFrom(inspectFile(bundle));
    if (areFaultsSought) result.set("faults", faultsFrom(findFaultsInFile(bundle)));
    return result;
  });
}

// For the tests that compare the lists of both languages.
val errorCodes() {
  val result = val::array();
  for (std::string_view code : kErrorCodeNames) result.call<void>("push", std::string(code));
  return result;
}

val defaultOptions() { return objectFrom(RemeshOptions()); }

EMSCRIPTEN_BINDINGS(remesher_whole) {
  emscripten::function("repair", &repairArrays);
  emscripten::function("remeshFile", &remeshBytes);
  emscripten::function("repairFile", &repairBytes);
  emscripten::function("convertFile", &convertBytes);
  emscripten::function("inspectClosely", &inspectClosely);
  emscripten::function("inspectFile", &inspectBytes);
  emscripten::function("errorCodes", &errorCodes);
  emscripten::function("defaultOptions", &defaultOptions);
}

}  // namespace
}  // namespace remesher
