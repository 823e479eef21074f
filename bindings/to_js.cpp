// SPDX-License-Identifier: MIT
#include "to_js.h"

#include <emscripten/heap.h>

#include <algorithm>
#include <functional>
#include <string>

#include "choice_names.h"

namespace remesher {

using emscripten::typed_memory_view;
using emscripten::val;

val (*repairInJs)(const RepairReport& repair) = nullptr;
val (*droppedInJs)(const DropReport& dropped) = nullptr;
val (*atlasInJs)(const AtlasReport& atlas) = nullptr;
val (*wantedInJs)(const WantedReport& wanted) = nullptr;
val (*conformInJs)(const ConformReport& conform) = nullptr;

namespace {

val objectFrom(const AngleStatistics& angles) {
  val result = val::object();
  val histogram = val::array();
  for (double percent : angles.histogram) histogram.call<void>("push", percent);
  result.set("worst", angles.worst);
  result.set("mean", angles.mean);
  result.set("histogram", histogram);
  return result;
}

val objectFrom(const QuadReport& quads) {
  val deviation = val::object(), jacobian = val::object(), result = val::object();
  deviation.set("mean", quads.angleDeviation.mean);
  deviation.set("p95", quads.angleDeviation.p95);
  deviation.set("worst", quads.angleDeviation.worst);
  jacobian.set("min", quads.scaledJacobian.min);
  jacobian.set("mean", quads.scaledJacobian.mean);
  result.set("count", double(quads.count));
  result.set("irregular", double(quads.irregular));
  result.set("angleDeviation", deviation);
  result.set("scaledJacobian", jacobian);
  result.set("edgeVariation", quads.edgeVariation);
  result.set("symmetry", double(quads.symmetry));
  val loops = val::object(), paired = val::array();
  loops.set("count", double(quads.loops.count));
  loops.set("longest", quads.loops.longest);
  loops.set("selfCrossing", quads.loops.selfCrossing);
  for (const PairedPart& part : quads.paired) {
    val one = val::object(), at = val::array();
    for (const double x : part.at) at.call<void>("push", x);
    one.set("at", at);
    one.set("quads", double(part.quads));
    paired.call<void>("push", one);
  }
  result.set("loops", loops);
  result.set("parts", double(quads.parts));
  result.set("paired", paired);
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
  if (mesh.quads) result.set("quads", objectFrom(*mesh.quads));
  if (mesh.wanted && wantedInJs) result.set("wanted", wantedInJs(*mesh.wanted));
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

val objectFrom(const Phase& phase) {
  val result = val::object();
  result.set("name", phase.name);
  result.set("milliseconds", phase.milliseconds);
  return result;
}

val objectFrom(const Attribute& attribute) {
  val result = val::object();
  result.set("semantic", attribute.semantic);
  result.set("itemSize", attribute.itemSize);
  result.set("array", arrayFrom(attribute.values));
  return result;
}

val objectFrom(const File& file) {
  val result = val::object();
  result.set("name", file.name);
  result.set("bytes", arrayFrom(file.bytes));
  return result;
}

val objectFrom(const Picture& picture) {
  val result = val::object();
  result.set("name", picture.name);
  result.set("type", picture.type);
  result.set("width", double(picture.width));
  result.set("height", double(picture.height));
  result.set("texels", arrayFrom(picture.texels));
  return result;
}

val objectFrom(const Vec3& place) {
  val result = val::array();
  for (const double coordinate : place) result.call<void>("push", coordinate);
  return result;
}

val objectFrom(const Warning& warning) {
  val result = val::object();
  result.set("code", warning.code);
  result.set("message", warning.message);
  result.set("count", double(warning.count));
  result.set("severity", std::string(nameOf(kSeverities, severityOf(warning))));
  if (warning.at) result.set("at", objectFrom(*warning.at));
  return result;
}

val objectFrom(const Chosen& chosen) {
  val result = val::object();
  result.set("rule", chosen.rule);
  result.set("reason", chosen.reason);
  return result;
}

val objectFrom(Prefer part) { return val(std::string(nameOf(kPrefers, part))); }

// A list of the objects of all values.
template <class T>
val listFrom(const std::vector<T>& values) {
  val result = val::array();
  for (const T& value : values) result.call<void>("push", objectFrom(value));
  return result;
}

// One value for all parts; a list where they differ.
template <class T>
val ofParts(const std::vector<T>& parts) {
  const bool isOne =
      std::adjacent_find(parts.begin(), parts.end(), std::not_equal_to()) == parts.end();
  return isOne ? objectFrom(parts.front()) : listFrom(parts);
}

}  // namespace

val objectFrom(const TriangleMesh& mesh) {
  val result = val::object();
  const double* positions = mesh.positions.empty() ? nullptr : mesh.positions.front().data();
  result.set("positions",
             val(typed_memory_view(3 * mesh.positions.size(), positions)).call<val>("slice"));
  result.set("indices", arrayFrom(mesh.indices));
  result.set("attributes", listFrom(mesh.attributes));
  if (!mesh.groups.empty()) result.set("groups", arrayFrom(mesh.groups));
  if (mesh.isQuads) result.set("quads", arrayFrom(quadsOf(mesh)));
  return result;
}

val objectFrom(const std::vector<TriangleMesh>& meshes) { return listFrom(meshes); }

val objectFrom(const std::vector<File>& files) { return listFrom(files); }

val objectFrom(const std::vector<Picture>& pictures) { return listFrom(pictures); }

val objectFrom(const std::vector<Warning>& warnings) { return listFrom(warnings); }

// WebAssembly's memory only grows: its size now is the peak.
val objectFrom(const Report& report) {
  val memory = val::object();
  memory.set("peakBytes", double(emscripten_get_heap_size()));
  val result = val::object();
  result.set("version", std::string(REMESHER_VERSION));
  result.set("input", objectFrom(report.input));
  result.set("diagonal", report.input.diagonal);
  if (report.output) result.set("output", objectFrom(*report.output));
  if (report.fidelity) result.set("fidelity", objectFrom(*report.fidelity));
  if (report.repair && repairInJs) result.set("repair", repairInJs(*report.repair));
  if (report.dropped && droppedInJs) result.set("dropped", droppedInJs(*report.dropped));
  if (report.conform && conformInJs) result.set("conform", conformInJs(*report.conform));
  if (report.atlas && atlasInJs) result.set("atlas", atlasInJs(*report.atlas));
  if (!report.prefer.empty()) result.set("prefer", ofParts(report.prefer));
  if (!report.chosen.empty()) result.set("chosen", ofParts(report.chosen));
  result.set("timings", objectFrom(report.timings));
  result.set("memory", memory);
  result.set("phases", listFrom(report.phases));
  result.set("warnings", listFrom(report.warnings));
  if (report.output) result.set("stopped", std::string(nameOf(kStopped, report.stopped)));
  if (report.takesOver) {
    val takesOver = val::object();
    takesOver.set("coverage", report.takesOver->coverage);
    takesOver.set("distance", report.takesOver->distance);
    result.set("takesOver", takesOver);
  }
  if (!report.lods.empty()) result.set("lods", listFrom(report.lods));
  return result;
}

}  // namespace remesher
