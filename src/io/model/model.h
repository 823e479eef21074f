// SPDX-License-Identifier: MIT
// The content of a file: its surfaces as plain triangle meshes, each at its places in the world,
// and everything else in the file, which is kept unread for the writer of the same format. Between
// reading and writing a part's `mesh` may be replaced by a mesh with the same attribute semantics
// and group numbers; an unchanged part is written as it was.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/report.h"
#include "base/triangle_mesh.h"
#include "base/types.h"
#include "io/model/conventions.h"
#include "io/model/material.h"

namespace remesher::io {

// One glTF mesh with all its triangle primitives, or the whole of a file of another format.
//
// The groups of the mesh are the glTF primitives, the OBJ runs of equal object, group, material
// and smoothing, the textures of a PLY, the solids of an STL. An attribute that only some groups
// have is zero (COLOR_n: one) at the vertices of the others, and the writer leaves it out there.
// This is sound because no triangle mixes vertices of two groups' attributes: a group border is a
// feature curve.
// `groups` serves the writers of other formats: by group number, empty where the format has nothing
// to say.
struct GroupInfo {
  std::string material;            // its name
  std::vector<std::string> lacks;  // semantics of the mesh that this group lacks
  Material look = {};
  int painted = -1;  // number of the painting that replaces its material; -1: none
};

struct Part {
  std::string name;
  TriangleMesh mesh;                 // in local space
  std::vector<Transform> instances;  // local to world, one per place where the file shows it
  std::vector<GroupInfo> groups = {};
  std::vector<TriangleMesh> lods = {};  // coarser levels of detail, each like `mesh`; for glTF
  int source = -1;                      // the number of its mesh in the file, if numbered
  // The parts, by number, of which this one is a coarser level of detail; empty if it is none.
  std::vector<std::size_t> finer = {};
  std::size_t hidden = 0;  // number of hidden instances, the last ones
  // Per coarser level the share of a screen below which it is shown; empty if unknown.
  std::vector<double> coverages = {};
};

// Everything that a format's writer needs beside the parts. Each format derives its own class. The
// model owns the object, which never changes.
class Source {
 public:
  Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  virtual ~Source() = default;
};

// A painted map, to be encoded outside of the core.
struct PaintedImage {
  std::string name;
  std::string type;  // image/png, image/jpeg or image/webp
  Image image;
};

struct Model {
  std::vector<Part> parts;
  Conventions conventions = Conventions::Gltf;
  std::string unit = {};  // that its file states, as 3MF calls it
  std::vector<Warning> warnings;
  std::shared_ptr<const Source> source;  // null if the parts hold everything
  std::size_t polygons = 0;              // of more than three corners, that are cut into triangles
  std::vector<std::string> lost;         // semantics lost when parts became one
  bool replacesLevels = false;           // drop the source's levels of detail
  std::vector<int> leftOut = {};         // the numbers of meshes of the file that are shown no more
  bool isExact = false;             // in text coordinates get the digits of doubles, floats as well
  bool hasNewTexcoords = false;     // the parts' texture coordinates are not the file's
  bool sharesNodes = false;         // formats with nodes hold one for all parts at a place
  std::vector<Material> paintings;  // their maps name images below by number
  std::vector<PaintedImage> images;
};

}  // namespace remesher::io
