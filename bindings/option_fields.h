// SPDX-License-Identifier: MIT
// The options by their names in JavaScript. Reading options and reporting defaults both use this
// list. A test compares it with the table in package/base/options.js.
#pragma once

#include "remesher.h"

namespace remesher {

// options: RemeshOptions, const or not; visit: (name, field). These are what the engine for arrays
// knows.
template <class Options, class Visit>
void forEachOption(Options& options, const Visit& visit) {
  visit("vertices", options.vertices);
  visit("faces", options.faces);
  visit("ratio", options.ratio);
  visit("edgeLength", options.edgeLength);
  visit("scheme", options.scheme);
  visit("prefer", options.prefer);
  visit("quality", options.quality);
  visit("projection", options.projection);
  visit("fidelity", options.fidelity);
  visit("vertexAngle", options.vertexAngle);
  visit("triangleAngle", options.triangleAngle);
  visit("splitObtuse", options.splitObtuse);
  visit("adaptivity", options.adaptivity);
  visit("gradation", options.gradation);
  visit("featureAngle", options.featureAngle);
  visit("boundary", options.boundary);
  visit("maxError", options.maxError);
  visit("weld", options.weld);
  visit("quads", options.quads);
  visit("textures", options.textures);
  visit("density", options.density);
  visit("featureEdges", options.featureEdges);
  visit("repair", options.repair);
  visit("lods", options.lods);
}

// What only the whole engine can do anything with.
template <class Options, class Visit>
void forEachWholeOption(Options& options, const Visit& visit) {
  visit("exact", options.exact);
  visit("minEdge", options.minEdge);
  visit("maxEdge", options.maxEdge);
  visit("minAngle", options.minAngle);
  visit("region", options.region);
  visit("conform", options.conform);
  visit("symmetry", options.symmetry);
  visit("guides", options.guides);
  visit("textureSize", options.textureSize);
  visit("textureFormat", options.textureFormat);
  visit("cage", options.cage);
  visit("ao", options.ao);
  visit("holesUpTo", options.holesUpTo);
  visit("gap", options.gap);
  visit("cavities", options.cavities);
  visit("sheets", options.sheets);
  visit("keepRims", options.keepRims);
  visit("thickness", options.thickness);
  visit("base", options.base);
  visit("unite", options.unite);
  visit("dropBelow", options.dropBelow);
  visit("dropHidden", options.dropHidden);
  visit("lodFiles", options.lodFiles);
}

// Options in percent of the diagonal that may be lengths instead.
template <class Lengths, class Visit>
void forEachLength(Lengths& lengths, const Visit& visit) {
  visit("maxError", lengths.maxError);
  visit("weld", lengths.weld);
  visit("holesUpTo", lengths.holesUpTo);
  visit("gap", lengths.gap);
  visit("dropBelow", lengths.dropBelow);
}

}  // namespace remesher
