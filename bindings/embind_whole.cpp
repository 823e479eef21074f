// SPDX-License-Identifier: MIT
// The further functions of the whole WebAssembly module: repair and files. Code that is reached
// only from here, such as readers and writers, is not linked into the other module.
#include <emscripten/bind.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "choice_names.h"
#include "from_js.h"
#include "guarded.h"
#include "option_fields.h"
#include "option_reader.h"
#include "remesher.h"
#include "to_js.h"

namespace remesher {
namespace {

using emscripten::val;

val fileResult(const RemeshFileResult& run) {
  val result = val::object();
  result.set("files", objectFrom(run.files));
  if (!run.pictures.empty()) result.set("pictures", objectFrom(run.pictures));
  result.set("report", objectFrom(run.report));
  return result;
}

// request: { name, bytes, resources, output }
val remeshBytes(const val& request, const val& options, const val& onProgress) {
  return guarded([&] {
    FileBundle bundle = bundleFrom(request);
    const OptionReader read{options};
    read("slabs", bundle.slabs.count), read("slab", bundle.slabs.only);
    return fileResult(remeshFile(std::move(bundle), request["output"].as<std::string>(),
                                 optionsFrom(options), progressFrom(onProgress)));
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
    return fileResult(repairFile(bundleFrom(request), request["output"].as<std::string>(),
                                 optionsFrom(options), progressFrom(onProgress)));
  });
}

// The package has checked the name.
BooleanOperation operationFrom(const val& request) {
  const auto given = request["operation"].as<std::string>();
  for (const auto& [name, operation] : kBooleans)
    if (name == given) return operation;
  throw Error(ErrorCode::InvalidOption, "There is no such operation.");
}

val objectFrom(const Report& report, const BooleanReport& made) {
  val summary = val::object(), result = objectFrom(report);
  summary.set("operation", std::string(nameOf(kBooleans, made.operation)));
  summary.set("cut", double(made.cut));
  summary.set("selfIntersections", double(made.selfIntersections));
  result.set("boolean", summary);
  return result;
}

// request: { a, b, operation }, two meshes
val booleanOfArrays(const val& request, const val& onProgress) {
  return guarded([&] {
    const BooleanResult run = boolean(meshFrom(request["a"]), meshFrom(request["b"]),
                                      operationFrom(request), progressFrom(onProgress));
    val result = val::object();
    result.set("meshes", objectFrom(std::vector<TriangleMesh>{run.mesh}));
    result.set("report", objectFrom(run.report, run.boolean));
    return result;
  });
}

// request: { a, b, operation, output }, two of { name, bytes, resources }
val booleanOfFiles(const val& request, const val& onProgress) {
  return guarded([&] {
    const BooleanFilesResult run =
        booleanFiles(bundleFrom(request["a"]), bundleFrom(request["b"]), operationFrom(request),
                     request["output"].as<std::string>(), progressFrom(onProgress));
    val result = val::object();
    result.set("files", objectFrom(run.files));
    result.set("report", objectFrom(run.report, run.boolean));
    return result;
  });
}

// request: { high, low }, two meshes
val bakeArrays(const val& request, const val& options, const val& onProgress) {
  return guarded([&] {
    const BakeResult run = bake(meshFrom(request["high"]), meshFrom(request["low"]),
                                optionsFrom(options), progressFrom(onProgress));
    val result = val::object();
    result.set("meshes", objectFrom(std::vector<TriangleMesh>{run.mesh}));
    result.set("maps", objectFrom(run.maps));
    result.set("report", objectFrom(run.report));
    return result;
  });
}

// request: { high, low, output }, two of { name, bytes, resources }
val bakeBytes(const val& request, const val& options, const val& onProgress) {
  return guarded([&] {
    return fileResult(bakeFiles(bundleFrom(request["high"]), bundleFrom(request["low"]),
                                request["output"].as<std::string>(), optionsFrom(options),
                                progressFrom(onProgress)));
  });
}

val unwrapArrays(const val& mesh, const val& options, const val& onProgress) {
  return guarded([&] {
    const UnwrapResult run = unwrap(meshFrom(mesh), optionsFrom(options), progressFrom(onProgress));
    val result = val::object();
    result.set("meshes", objectFrom(std::vector<TriangleMesh>{run.mesh}));
    result.set("report", objectFrom(run.report));
    return result;
  });
}

// request: { name, bytes, resources, output }
val unwrapBytes(const val& request, const val& options, const val& onProgress) {
  return guarded([&] {
    return fileResult(unwrapFile(bundleFrom(request), request["output"].as<std::string>(),
                                 optionsFrom(options), progressFrom(onProgress)));
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

// Coordinates of all, three each.
val coordinatesOf(const std::vector<Vec3>& places) {
  val result = val::array();
  for (const Vec3& place : places)
    for (const double x : place) result.call<void>("push", x);
  return result;
}

// { at: [x, y, z], across } each
val sizedPlaces(const std::vector<SizedPlace>& places) {
  val result = val::array();
  for (const SizedPlace& place : places) {
    val one = val::object();
    one.set("at", coordinatesOf({place.at}));
    one.set("across", place.across);
    result.call<void>("push", one);
  }
  return result;
}

val writtenDrop(const DropReport& dropped) {
  val result = val::object();
  result.set("pieces", double(dropped.pieces));
  result.set("hidden", double(dropped.hidden));
  result.set("lost", dropped.lost);
  result.set("piecesAt", sizedPlaces(dropped.piecesAt));
  result.set("hiddenAt", coordinatesOf(dropped.hiddenAt));
  return result;
}

val writtenWanted(const WantedReport& wanted) {
  val result = val::object();
  const auto add = [&](const char* name, const std::optional<WantedFigure>& figure) {
    if (!figure) return;
    val one = val::object();
    one.set("asked", figure->asked);
    one.set("worst", figure->worst);
    one.set("missed", double(figure->missed));
    one.set("kept", figure->kept);
    if (figure->at) one.set("at", coordinatesOf({*figure->at}));
    result.set(name, one);
  };
  add("minEdge", wanted.minEdge);
  add("maxEdge", wanted.maxEdge);
  add("minAngle", wanted.minAngle);
  return result;
}

val writtenConform(const ConformReport& conform) {
  val result = val::object();
  result.set("faces", double(conform.faces));
  result.set("triangles", double(conform.triangles));
  result.set("area", conform.area);
  return result;
}

val writtenAtlas(const AtlasReport& atlas) {
  val result = val::object();
  result.set("size", double(atlas.size));
  result.set("charts", double(atlas.charts));
  result.set("given", atlas.isGiven);
  result.set("coverage", atlas.coverage);
  result.set("stretch", atlas.stretch);
  result.set("worstStretch", atlas.worstStretch);
  if (atlas.cage > 0) result.set("cage", atlas.cage);
  if (atlas.cage > 0) result.set("notFound", atlas.notFound);
  return result;
}

val writtenRepair(const RepairReport& repair) {
  val result = val::object();
  val selfIntersections = val::array();
  for (const std::size_t count : repair.selfIntersections)
    selfIntersections.call<void>("push", double(count));
  result.set("mode", repair.mode);
  result.set("reason", repair.reason);
  result.set("holes", double(repair.holes));
  result.set("islands", double(repair.islands));
  result.set("shells", double(repair.shells));
  result.set("turned", double(repair.turned));
  result.set("rims", double(repair.rims));
  result.set("bodies", double(repair.bodies));
  result.set("closedAt", sizedPlaces(repair.closedAt));
  result.set("rimsAt", sizedPlaces(repair.rimsAt));
  result.set("lost", repair.lost);
  result.set("lostBeyond", repair.lostBeyond);
  result.set("lostAt", coordinatesOf(repair.lostAt));
  result.set("selfIntersections", selfIntersections);
  return result;
}

val faultsFrom(const FaultReport& faults) {
  val result = val::object(), loops = val::array();
  for (const double length : faults.openLoops) loops.call<void>("push", length);
  result.set("openLoops", loops);
  result.set("selfIntersections", double(faults.selfIntersections));
  result.set("innerShells", double(faults.innerShells));
  result.set("insideOut", double(faults.insideOut));
  result.set("repair", std::string(nameOf(kRepairs, faults.repair)));
  val needs = val::object();
  needs.set("bytes", faults.needs.bytes);
  needs.set("seconds", faults.needs.seconds);
  result.set("needs", needs);
  val places = val::object();
  using Named = std::pair<const char*, const std::vector<Vec3>*>;
  const FaultPlaces& at = faults.places;
  for (const auto& [name, all] : {Named{"openLoops", &at.openLoops},
                                  {"selfIntersections", &at.selfIntersections},
                                  {"innerShells", &at.innerShells},
                                  {"insideOut", &at.insideOut}})
    places.set(name, coordinatesOf(*all));
  result.set("places", places);
  return result;
}

val edgesFrom(const EdgeReport& edges) {
  val result = val::object();
  result.set("boundary", arrayFrom(edges.boundary));
  result.set("nonManifold", arrayFrom(edges.nonManifold));
  result.set("flipped", arrayFrom(edges.flipped));
  result.set("bent", arrayFrom(edges.bent));
  result.set("bends", arrayFrom(edges.bends));
  result.set("first", arrayFrom(edges.first));
  return result;
}

val objectFrom(const CloseInspection& close) {
  val result = objectFrom(close.report);
  if (close.faults) result.set("faults", faultsFrom(*close.faults));
  return result;
}

// wanted: { faults, edges }
val inspectArraysClosely(const val& mesh, const val& wanted) {
  return guarded([&] {
    const TriangleMesh given = meshFrom(mesh);
    val result = wanted["faults"].as<bool>() ? objectFrom(inspectClosely(given))
                                             : objectFrom(inspect(given));
    if (wanted["edges"].as<bool>()) result.set("edges", edgesFrom(findEdges(given)));
    return result;
  });
}

// request: { name, bytes, resources }
val inspectBytes(const val& request, bool areFaultsSought, const val& onProgress) {
  return guarded([&] {
    const FileBundle bundle = bundleFrom(request);
    const Progress progress = progressFrom(onProgress);
    return areFaultsSought ? objectFrom(inspectFileClosely(bundle, progress))
                           : objectFrom(inspectFile(bundle, progress));
  });
}

// For the tests that compare the lists of both languages.
val errorCodes() {
  val result = val::array();
  for (std::string_view code : kErrorCodeNames) result.call<void>("push", std::string(code));
  return result;
}

// null: left to the scheme, or none.
val defaultOptions() {
  const RemeshOptions options;
  val result = val::object();
  const auto write = [&]<class T>(const char* name, const T& field) {
    if constexpr (std::is_enum_v<T>)
      result.set(name, std::string(nameOf(namesOf(field), field)));
    else if constexpr (std::is_arithmetic_v<T>)
      result.set(name, field);
    else
      result.set(name, val::null());
  };
  forEachOption(options, write);
  forEachWholeOption(options, write);
  return result;
}

void readRest(const val& object, RemeshOptions& options) {
  forEachWholeOption(options, OptionReader{object});
}

EMSCRIPTEN_BINDINGS(remesher_whole) {
  readWholeOptions = &readRest;
  repairInJs = &writtenRepair;
  droppedInJs = &writtenDrop;
  atlasInJs = &writtenAtlas;
  wantedInJs = &writtenWanted;
  conformInJs = &writtenConform;
  emscripten::function("repair", &repairArrays);
  emscripten::function("remeshFile", &remeshBytes);
  emscripten::function("repairFile", &repairBytes);
  emscripten::function("boolean", &booleanOfArrays);
  emscripten::function("booleanFiles", &booleanOfFiles);
  emscripten::function("bake", &bakeArrays);
  emscripten::function("bakeFile", &bakeBytes);
  emscripten::function("unwrap", &unwrapArrays);
  emscripten::function("unwrapFile", &unwrapBytes);
  emscripten::function("convertFile", &convertBytes);
  emscripten::function("inspectClosely", &inspectArraysClosely);
  emscripten::function("inspectFile", &inspectBytes);
  emscripten::function("errorCodes", &errorCodes);
  emscripten::function("defaultOptions", &defaultOptions);
}

}  // namespace
}  // namespace remesher
