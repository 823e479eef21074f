// SPDX-License-Identifier: MIT
// Paints maps for a model's parts from originals: lays the triangles of each atlas out, paints its
// maps, and hands them to the model as a material.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/input_place.h"
#include "base/options.h"
#include "base/progress.h"
#include "base/report.h"
#include "io/model/model.h"
#include "textures/painting/paint_source.h"

namespace remesher {

// Whether painting replaces this attribute.
bool isPainted(const std::string& semantic);

// The material of a group.
io::Material lookOf(const io::Part& part, Index group);

// How parts are painted that were not made from their originals, but lie near them.
struct OntoRules {
  bool keepsTexcoords;  // the parts' texture coordinates are used; else they get new ones
};

struct PaintingInput {
  const std::vector<io::Part>& originals;
  std::span<const io::NamedImage> images;
  // Per original and group, and per part and group, the number of the maps that are shared.
  const std::vector<std::vector<Index>>& classes;
  const std::vector<std::vector<Index>>& partClasses;
  const std::vector<std::vector<InputPlace>>& places;  // per part and corner
  const RemeshOptions& options;
  Unshaded unshaded;
  std::vector<char> areGiven;     // per part, whether its places are on its original
  std::vector<Index> originalOf;  // per part the number of its original
  // Per original how far paint is looked for along the normals; empty: on the surface that is
  // connected to the places.
  std::vector<double> cages = {};
  std::optional<OntoRules> onto = {};
};

// Paints the maps of classes 0 to classCount - 1 and gives the model their materials, and its parts
// the texture coordinates, normals and tangents for them. Throws INVALID_OPTION.
AtlasReport paintAtlases(const PaintingInput& input, io::Model& model, Index classCount,
                         const Progress& progress);

// A warning for each kind of map that cannot be painted.
std::vector<Warning> unpaintedMaps(const std::vector<io::Part>& parts);

// A warning if parts have texture coordinates beside TEXCOORD_0: baked maps need one set.
std::vector<Warning> furtherTexcoords(const std::vector<io::Part>& parts);

}  // namespace remesher
