// SPDX-License-Identifier: MIT
#include "to_js.h"

#include <emscripten/heap.h>

#include <string>
#include <type_traits>

#include "choice_names.h"
#include "option_fields.h"

namespace remesher {

using emscripten::typed_memory_view;
using emscripten::val;

namespace {

template <class T>
val arrayFrom(const std::vector<T>& values) {
  return val(typed_memory_view(values.size(), values.data())).template call<val>("slice");
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

val objectFrom(const std::vector<Phase>& phases) {
  val result = val::array();
  for (const Phase& phase : phases) {
    val object = val::object();
    object.set("name", phase.name);
    object.set("milliseconds", phase.milliseconds);
    result.call<void>("push", object);
  }
  return result;
}

}  // namespace

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
  if (!mesh.groups.empty()) result.set("groups", arrayFrom(mesh.groups));
  return result;
}

val objectFrom(const std::vector<TriangleMesh>& meshes) {
  val result = val::array();
  for (const TriangleMesh& mesh : meshes) result.call<void>("push", objectFrom(mesh));
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

val objectFrom(const std::vector<Picture>& pictures) {
  val result = val::array();
  for (const Picture& picture : pictures) {
    val object = val::object();
    object.set("name", picture.name);
    object.set("type", picture.type);
    object.set("width", double(picture.width));
    object.set("height", double(picture.height));
    object.set("texels", arrayFrom(picture.texels));
    result.call<void>("push", object);
  }
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
  result.set("phases", objectFrom(report.phases));
  result.set("warnings", objectFrom(report.warnings));
  if (report.output) result.set("stopped", std::string(nameOf(kStopped, report.stopped)));
  if (!report.lods.empty()) {
    val lods = val::array();
    for (const Report& lod : report.lods) lods.call<void>("push", objectFrom(lod));
    result.set("lods", lods);
  }
  return result;
}

val objectFrom(const RemeshOptions& options) {
  val result = val::object();
  forEachOption(options, [&]<class T>(const char* name, const T& field) {
    if constexpr (std::is_enum_v<T>)
      result.set(name, std::string(nameOf(namesOf(field), field)));
    else if constexpr (std::is_arithmetic_v<T>)
      result.set(name, field);
    else
      result.set(name, val::null());
  });
  return result;
}

}  // namespace remesher
