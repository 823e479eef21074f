// SPDX-License-Identifier: MIT
// The WebAssembly module: free functions from plain objects to plain objects. Typed arrays are
// copied in and out, so that nothing in JavaScript ever points into this memory and no handle has
// to be freed. Every failure comes back as { error: { code, message, hint } }; the caller has
// checked names and types of the options (package/options.js), the core checks what they mean.
#include <emscripten/bind.h>
#include <emscripten/emscripten.h>
#include <emscripten/heap.h>
#include <emscripten/val.h>

#include <new>

#include "remesher.h"

namespace remesher {
namespace {

using emscripten::typed_memory_view;
using emscripten::val;

template <class E>
using Names = std::vector<std::pair<const char*, E>>;

const Names<Scheme> kSchemes = {{"best", Scheme::Best}, {"rounds", Scheme::Rounds}};
const Names<Projection> kProjections = {{"patches", Projection::Patches},
                                        {"current", Projection::Current}};
const Names<Fidelity> kFidelities = {
    {"strict", Fidelity::Strict}, {"loose", Fidelity::Loose}, {"fold", Fidelity::Fold}};
const Names<Boundary> kBoundaries = {{"resample", Boundary::Resample}, {"keep", Boundary::Keep}};
const Names<Stopped> kStopped = {{"target", Stopped::Target},
                                 {"fidelity", Stopped::Fidelity},
                                 {"max-error", Stopped::MaxError},
                                 {"cancelled", Stopped::Cancelled}};

template <class E>
val nameOf(const Names<E>& names, E value) {
  for (const auto& [name, known] : names)
    if (known == value) return val(name);
  return val::undefined();
}

// ---- in ------------------------------------------------------------------------------------

template <class T>
std::vector<T> copied(const val& array) {
  std::vector<T> result(array["length"].as<std::size_t>());
  if (!result.empty())
    val(typed_memory_view(result.size(), result.data())).call<void>("set", array);
  return result;
}

template <class Visit>
void forEach(const val& array, Visit visit) {
  const auto length = array["length"].as<unsigned>();
  for (unsigned i = 0; i < length; ++i) visit(array[i]);
}

TriangleMesh meshFrom(const val& object) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  TriangleMesh mesh;
  const val positions = object["positions"];
  mesh.positions.resize(positions["length"].as<std::size_t>() / 3);
  if (!mesh.positions.empty())
    val(typed_memory_view(3 * mesh.positions.size(), mesh.positions.front().data()))
        .call<void>("set", positions);
  mesh.indices = copied<Index>(object["indices"]);
  forEach(object["attributes"], [&](const val& attribute) {
    mesh.attributes.push_back({attribute["semantic"].as<std::string>(),
                               attribute["itemSize"].as<int>(), copied<float>(attribute["array"])});
  });
  return mesh;
}

File fileFrom(const val& object) {
  return {object["name"].as<std::string>(), copied<std::uint8_t>(object["bytes"])};
}

std::vector<File> filesFrom(const val& array) {
  std::vector<File> files;
  forEach(array, [&](const val& object) { files.push_back(fileFrom(object)); });
  return files;
}

// The options that are set, read into what has the same name.
struct OptionReader {
  val options;

  template <class T>
  void number(const char* name, T& target) const {
    if (const val value = options[name]; value.isNumber()) target = value.as<double>();
  }
  template <class E, class T>
  void choice(const char* name, const Names<E>& names, T& target) const {
    const val value = options[name];
    if (!value.isString()) return;
    for (const auto& [known, choice] : names)
      if (value.as<std::string>() == known) target = choice;
  }
};

RemeshOptions optionsFrom(const val& object) {
  const OptionReader read{object};
  RemeshOptions options;
  if (const val count = object["vertices"]; count.isNumber()) options.vertices = count.as<Index>();
  read.number("ratio", options.ratio);
  read.number("edgeLength", options.edgeLength);
  read.choice("scheme", kSchemes, options.scheme);
  read.choice("projection", kProjections, options.projection);
  read.choice("fidelity", kFidelities, options.fidelity);
  read.number("vertexAngle", options.vertexAngle);
  read.number("triangleAngle", options.triangleAngle);
  options.splitObtuse = object["splitObtuse"].isTrue();
  read.number("adaptivity", options.adaptivity);
  read.number("gradation", options.gradation);
  read.number("featureAngle", options.featureAngle);
  options.detectFeatures = !object["featureAngle"].isString();
  read.choice("boundary", kBoundaries, options.boundary);
  read.number("maxError", options.maxError);
  if (const val density = object["density"]; !density.isUndefined())
    options.density = copied<float>(density);
  if (const val edges = object["featureEdges"]; !edges.isUndefined()) {
    const std::vector<Index> flat = copied<Index>(edges);
    for (std::size_t i = 0; i + 1 < flat.size(); i += 2)
      options.featureEdges.emplace_back(flat[i], flat[i + 1]);
  }
  return options;
}

// The callback is asked at most every 50 ms, and at the start of every phase: asking takes longer
// than many a step.
Progress progressFrom(const val& callback) {
  if (callback.isUndefined()) return Progress();
  return Progress([callback, last = -1e9, phase = std::string()](std::string_view now,
                                                                 double fraction) mutable {
    const double time = emscripten_get_now();
    if (now == phase && time - last < 50) return true;
    last = time;
    phase = now;
    return !callback(phase, fraction).isFalse();
  });
}

// ---- out -----------------------------------------------------------------------------------

template <class T>
val arrayFrom(const std::vector<T>& values) {
  return val(typed_memory_view(values.size(), values.data())).template call<val>("slice");
}

val objectFrom(const TriangleMesh& mesh) {
  val attributes = val::array();
  for (const Attribute& attribute : mesh.attributes) {
    val object = val::object();
    object.set("semantic", attribute.semantic);
    object.set("itemSize", attribute.itemSize);
    object.set("array", arrayFrom(attribute.values));
    attributes.call<void>("push", object);
  }
  val result = val::object();
  const double* positions = mesh.positions.empty() ? nullptr : mesh.positions.front().data();
  result.set("positions",
             val(typed_memory_view(3 * mesh.positions.size(), positions)).call<val>("slice"));
  result.set("indices", arrayFrom(mesh.indices));
  result.set("attributes", attributes);
  return result;
}

val objectFrom(const std::vector<File>& files) {
  val result = val::array();
  for (const File& file : files) {
    val object = val::object();
    object.set("name", file.name);
    object.set("bytes", arrayFrom(file.bytes));
    result.call<void>("push", object);
  }
  return result;
}

val objectFrom(const AngleStatistics& angles) {
  val result = val::object();
  val histogram = val::array();
  for (double percent : angles.histogram) histogram.call<void>("push", percent);
  result.set("worst", angles.worst);
  result.set("mean", angles.mean);
  result.set("histogram", histogram);
  return result;
}

val objectFrom(const MeshReport& mesh) {
  val result = val::object();
  result.set("vertices", double(mesh.vertices));
  result.set("triangles", double(mesh.triangles));
  result.set("components", double(mesh.components));
  result.set("boundaryEdges", double(mesh.boundaryEdges));
  result.set("nonManifoldEdges", double(mesh.nonManifoldEdges));
  result.set("eulerCharacteristic", double(mesh.eulerCharacteristic));
  result.set("degenerateTriangles", double(mesh.degenerateTriangles));
  result.set("minAngle", objectFrom(mesh.minAngle));
  result.set("maxAngle", mesh.maxAngle);
  result.set("valence6", mesh.valence6);
  return result;
}

val objectFrom(const FidelityReport& fidelity) {
  val result = val::object();
  result.set("hausdorff", fidelity.hausdorff);
  result.set("rms", fidelity.rms);
  return result;
}

val objectFrom(const Timings& timings) {
  val result = val::object();
  result.set("read", timings.read);
  result.set("build", timings.build);
  result.set("remesh", timings.remesh);
  result.set("write", timings.write);
  return result;
}

val objectFrom(const std::vector<Warning>& warnings) {
  val result = val::array();
  for (const Warning& warning : warnings) {
    val object = val::object();
    object.set("code", warning.code);
    object.set("message", warning.message);
    object.set("count", double(warning.count));
    result.call<void>("push", object);
  }
  return result;
}

// WebAssembly's memory only grows: its size now is the peak.
val objectFrom(const Report& report) {
  val memory = val::object();
  memory.set("peakBytes", double(emscripten_get_heap_size()));
  val result = val::object();
  result.set("version", std::string(REMESHER_VERSION));
  result.set("input", objectFrom(report.input));
  if (report.output) result.set("output", objectFrom(*report.output));
  if (report.fidelity) result.set("fidelity", objectFrom(*report.fidelity));
  result.set("timings", objectFrom(report.timings));
  result.set("memory", memory);
  result.set("warnings", objectFrom(report.warnings));
  if (report.output) result.set("stopped", nameOf(kStopped, report.stopped));
  return result;
}

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

// ---- the functions ---------------------------------------------------------------------------

val remeshArrays(const val& mesh, const val& options, const val& onProgress) {
  return guarded([&] {
    const RemeshResult run = remesh(meshFrom(mesh), optionsFrom(options), progressFrom(onProgress));
    val result = val::object();
    result.set("mesh", objectFrom(run.mesh));
    result.set("report", objectFrom(run.report));
    return result;
  });
}

// request: { name, bytes, resources, output }
val remeshBytes(const val& request, const val& options, const val& onProgress) {
  return guarded([&] {
    const RemeshFileResult run = remeshFile(fileFrom(request), filesFrom(request["resources"]),
                                            request["output"].as<std::string>(),
                                            optionsFrom(options), progressFrom(onProgress));
    val result = val::object();
    result.set("files", objectFrom(run.files));
    result.set("report", objectFrom(run.report));
    return result;
  });
}

val inspectArrays(const val& mesh) {
  return guarded([&] { return objectFrom(inspect(meshFrom(mesh))); });
}

// request: { name, bytes, resources }
val inspectBytes(const val& request) {
  return guarded(
      [&] { return objectFrom(inspectFile(fileFrom(request), filesFrom(request["resources"]))); });
}

// For the tests that hold the lists of both languages together.
val errorCodes() {
  val result = val::array();
  for (std::string_view code : kErrorCodeNames) result.call<void>("push", std::string(code));
  return result;
}

val defaultOptions() {
  const RemeshOptions options;
  val result = val::object();
  result.set("scheme", nameOf(kSchemes, options.scheme));
  result.set("projection", nameOf(kProjections, options.projection));
  result.set("vertexAngle", options.vertexAngle);
  result.set("triangleAngle", options.triangleAngle);
  result.set("splitObtuse", options.splitObtuse);
  result.set("gradation", options.gradation);
  result.set("boundary", nameOf(kBoundaries, options.boundary));
  return result;
}

EMSCRIPTEN_BINDINGS(remesher) {
  emscripten::function("remesh", &remeshArrays);
  emscripten::function("remeshFile", &remeshBytes);
  emscripten::function("inspect", &inspectArrays);
  emscripten::function("inspectFile", &inspectBytes);
  emscripten::function("errorCodes", &errorCodes);
  emscripten::function("defaultOptions", &defaultOptions);
}

}  // namespace
}  // namespace remesher
