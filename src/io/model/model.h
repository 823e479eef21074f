// SPDX-License-Identifier: MIT
// What a file holds: its surfaces as plain triangle meshes, each where the file puts it in the
// world, and whatever else the file says, kept unseen for the writer of the same format to put
// back. Between reading and writing a part's `mesh` may be replaced by another one with the same
// attribute semantics and group numbers; a part left as it was is written as it was.
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

// One glTF mesh with all its triangle primitives, or all of a file of another format.
//
// The groups of the mesh are the glTF primitives, the OBJ runs of equal object, group, material
// and smoothing, the textures of a PLY, the solids of an STL. An attribute that only some groups
// have is zero (COLOR_n: one) at the vertices of the others, and the writer leaves it out there.
// This is sound because no triangle mixes vertices of two groups' attributes: a group border is a
// feature curve.
//
// `groups` is for writing another format than the one read: by group number, and empty where the
// format has nothing to say.
struct GroupInfo {
  std::string material;            // its name
  std::vector<std::string> lacks;  // semantics that the mesh has and this group has not
  Material look = {};
  int painted = -1;  // which of the model's paintings it has instead, if any
};

struct Part {
  std::string name;
  TriangleMesh mesh;                 // in local space
  std::vector<Transform> instances;  // local to world, one per place where the file shows it
  std::vector<GroupInfo> groups = {};
  std::vector<TriangleMesh> lods = {};  // coarser levels of detail, each like `mesh`; for glTF
  int source = -1;                      // the number of its mesh in its file, where that has some
  // The parts, by number, that this one stands for from afar; none: it is no level of detail.
  std::vector<std::size_t> finer = {};
  std::size_t hidden = 0;  // how many of the instances, the last ones, the file hides
};

// Everything a format's writer needs to put back what the parts do not hold. Each format derives
// its own; the model owns it, nobody changes it.
class Source {
 public:
  Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  virtual ~Source() = default;
};

// A map that was painted, to be encoded by somebody else.
struct PaintedImage {
  std::string name;
  std::string type;  // image/png, image/jpeg or image/webp
  Image image;
};

struct Model {
  std::vector<Part> parts;
  Conventions conventions = Conventions::Gltf;
  std::vector<Warning> warnings;
  std::shared_ptr<const Source> source;  // none where the parts hold everything
  bool replacesLevels = false;           // the levels of detail that the source has are to go
  std::vector<Material> paintings;       // their maps are called by the number of the image below
  std::vector<PaintedImage> images;
};

}  // namespace remesher::io
