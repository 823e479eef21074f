// SPDX-License-Identifier: MIT
#include "io/formats.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/legible.h"
#include "io/contents.h"
#include "io/gltf/gltf.h"
#include "io/gltf/gltf_union.h"
#include "io/model/bake.h"
#include "io/model/byte_reader.h"
#include "io/model/companions.h"
#include "io/model/dropped.h"
#include "io/model/named_bodies.h"
#include "io/model/near_origin.h"
#include "io/model/resources.h"
#include "io/named/abaqus.h"
#include "io/named/gmsh.h"
#include "io/named/threemf.h"
#include "io/named/vtu.h"
#include "io/ply/ply.h"
#include "io/stl/stl.h"
#include "io/text/obj.h"
#include "io/text/off.h"

namespace remesher::io {
namespace {

struct Format {
  std::string_view extension;
  std::string_view inWords;
  Model (*read)(const File& file, const std::vector<File>& resources);  // null: only written
  WrittenFiles (*write)(const Model& model, const std::string& outputName);
  unsigned holds;

  bool has(Holds what) const { return (holds & what) != 0; }
};

constexpr Format kFormats[] = {
    {".glb", "a GLB", readGltf, writeGlb,
     kHoldsParts | kHoldsMeshes | kHoldsScenes | kHoldsImages | kHoldsTexcoords | kHoldsPolygons},
    {".gltf", "a glTF", readGltf, writeGltf,
     kHoldsParts | kHoldsMeshes | kHoldsScenes | kHoldsImages | kHoldsTexcoords | kHoldsPolygons},
    {".obj", "an OBJ", readObj, writeObj,
     kHoldsParts | kHoldsDoubles | kHoldsTexcoords | kHoldsPolygons},
    {".off", "an OFF", readOff, writeOff, kHoldsDoubles | kHoldsTexcoords | kHoldsPolygons},
    {".ply", "a PLY", readPly, writePly, kHoldsDoubles | kHoldsTexcoords | kHoldsPolygons},
    {".stl", "an STL", readStl, writeStl, 0},
    {".3mf", "a 3MF", readThreemf, writeThreemf, kHoldsParts | kHoldsMeshes | kHoldsDoubles},
    {".msh", "a Gmsh file", readGmsh, writeGmsh, kHoldsParts | kHoldsDoubles | kHoldsPolygons},
    {".vtu", "a VTU", readVtu, writeVtu, kHoldsParts | kHoldsDoubles | kHoldsPolygons},
    {".inp", "an Abaqus input", nullptr, writeAbaqus, kHoldsParts | kHoldsDoubles | kHoldsPolygons},
};

// Of all formats that are written, or of those that are also read.
std::string listOfExtensions(bool areRead) {
  std::string list;
  for (const Format& format : kFormats)
    if (format.read != nullptr || !areRead)
      list += (list.empty() ? "" : " ") + std::string(format.extension);
  return list;
}

const Format* findByExtension(std::string_view name) {
  const std::string lower = lowerCase(name);
  const auto found =
      std::find_if(std::begin(kFormats), std::end(kFormats),
                   [&](const Format& format) { return lower.ends_with(format.extension); });
  return found == std::end(kFormats) ? nullptr : &*found;
}

std::string_view withoutGz(std::string_view name) {
  constexpr std::string_view kGz = ".gz";
  if (lowerCase(name).ends_with(kGz)) name.remove_suffix(kGz.size());
  return name;
}

const Format* findByBytes(const Content& content) {
  return content.extension.empty() ? nullptr : findByExtension(content.extension);
}

// Whether a file that is known to be no model may still be what its name says, only broken: what
// is in JSON gets a better word from the reader of glTF.
bool mayBe(const Format* named, const File& file) {
  return named != nullptr && named->extension == ".gltf" && file.bytes[0] == '{';
}

// Text as Windows shells may write it: a mark, then two bytes per letter, one of which is zero.
bool isUtf16(const File& file) {
  const auto& b = file.bytes;
  return b.size() >= 4 && ((b[0] == 0xFF && b[1] == 0xFE && b[3] == 0) ||
                           (b[0] == 0xFE && b[1] == 0xFF && b[2] == 0));
}

// Whether a PLY is written in its own layout, which tells the textures of faces apart.
bool isOwnPly(const Model& model, const Format& format) {
  return format.write == writePly && dynamic_cast<const PlySource*>(model.source.get()) != nullptr;
}

bool hasMaps(const GroupInfo& group) {
  const Material& look = group.look;
  return look.baseColorMap || look.metalRoughMap || look.occlusionMap || look.emissiveMap ||
         look.normalMap;
}

std::size_t mappedGroups(const Model& model) {
  std::size_t count = 0;
  for (const Part& part : model.parts)
    count += std::size_t(std::count_if(part.groups.begin(), part.groups.end(), hasMaps));
  return count;
}

// The bodies that an OBJ names, by group: its objects, or its groups where it has none.
std::vector<std::string> bodyNames(const Model& model) {
  const auto* const source = dynamic_cast<const ObjSource*>(model.source.get());
  std::vector<std::string> names;
  if (source == nullptr) return names;
  for (const ObjGroup& group : source->groups)
    names.push_back(group.object.empty() ? group.groups : group.object);
  return names;
}

Model inBodies(Model model, const std::vector<std::string>& names) {
  model.parts = namedBodies(std::move(model.parts), names);
  return model;
}

}  // namespace

Model read(const File& file, const std::vector<File>& resources) {
  const Content inBlocks = file.source ? contentInBlocks(file) : Content{};
  if (file.source && inBlocks.extension.empty()) return read(whole(file), resources);
  if (!file.source && file.bytes.empty())
    throw Error(ErrorCode::EmptyFile, legible(file.name) + " is empty.",
                "Was it copied completely?");
  if (isUtf16(file))
    throw Error(ErrorCode::Unsupported, legible(file.name) + " is text in UTF-16.",
                "Save it as UTF-8.");
  const Content content = file.source ? inBlocks : contentOf(file);
  const Format* const named = findByExtension(withoutGz(file.name));
  const Format* const found = findByBytes(content);
  if (!content.what.empty() && !mayBe(named, file))
    throw Error(ErrorCode::UnknownFormat,
                legible(file.name) + " is " + std::string(content.what) + ", which is not read.",
                std::string(content.advice));
  const Format* const format = found != nullptr ? found : named;
  if (format == nullptr)
    throw Error(ErrorCode::UnknownFormat, legible(file.name) + " is in no format that can be read.",
                "Give a file that ends in one of " + listOfExtensions(true) + ".");
  if (format->read == nullptr)
    throw Error(ErrorCode::UnknownFormat,
                legible(file.name) + " is " + std::string(format->inWords) +
                    ", which is only written, not read.",
                "Give a file that ends in one of " + listOfExtensions(true) + ".");
  Model model = format->read(file, resources);
  if (named != nullptr && named != format)
    model.warnings.push_back({"NAME_CONTRADICTS",
                              legible(file.name) + " is " + std::string(format->inWords) +
                                  " by its bytes, though it is called " +
                                  std::string(named->extension) + ": it is read as what it is.",
                              1});
  return model;
}

void requireWritable(const std::string& outputName) {
  if (findByExtension(outputName) != nullptr) return;
  if (outputName.empty())
    throw Error(
        ErrorCode::UnknownFormat, "The output has no name, so its format is unknown.",
        "Give `name`, the input's, or `output`, ending in one of " + listOfExtensions(false) + ".");
  throw Error(ErrorCode::UnknownFormat,
              legible(outputName) + " names no format that can be written.",
              "Let its name end in one of " + listOfExtensions(false) + ".");
}

bool canHold(const std::string& outputName, Holds what) {
  const Format* const format = findByExtension(outputName);
  return format != nullptr && format->has(what);
}

void prepare(Model& model, const std::string& outputName) {
  const Format* const format = findByExtension(outputName);
  if (format == nullptr) return;
  if (!format->has(kHoldsScenes)) makeBodies(model);
  const bool isSingle =
      !format->has(kHoldsDoubles) || (format->write == writePly && becomesSingle(model));
  if (!isSingle) return;
  double coarsest = 0;
  for (Part& part : model.parts) {
    const bool wasExact = !std::exchange(part.mesh.isSingle, true);
    if (!wasExact || !isFarFromOrigin(part.mesh)) continue;
    if (format->has(kHoldsScenes))
      moveToOrigin(part);
    else
      coarsest = std::max(coarsest, singleStep(part.mesh));
  }
  if (coarsest == 0) return;
  model.warnings.push_back(
      {"ROUNDED_FAR_FROM_ORIGIN",
       "The coordinates are rounded to steps of " + inDigits(coarsest, 3) +
           ": a file of this format holds no finer ones so far from the origin. Write a .ply or "
           ".obj, or move the model to the origin first.",
       1});
}

void unite(Model& model, const std::string& outputName) {
  if (model.parts.size() < 2 || canHold(outputName, kHoldsParts)) return;
  for (const Warning& warning : mergedParts(model)) model.warnings.push_back(warning);
  TriangleMesh merged = mergeParts(model.parts);
  merged.groups.clear();
  // Normals of bodies that intersect jump where the one surface bends anyway.
  std::erase_if(merged.attributes, [](const Attribute& attribute) {
    return attribute.semantic == "NORMAL" || attribute.semantic == "TANGENT";
  });
  for (const Part& part : model.parts)
    for (const Attribute& attribute : part.mesh.attributes)
      if (!findAttribute(merged, attribute.semantic)) model.lost.push_back(attribute.semantic);
  model.parts.clear();
  model.parts.push_back({"", std::move(merged), {Transform::Identity()}});
}

void uniteAll(Model& model, const std::string& outputName) {
  if (!canHold(outputName, kHoldsParts)) return unite(model, outputName);
  const bool isScene = canHold(outputName, kHoldsScenes) && model.source != nullptr;
  if (isScene && model.conventions == Conventions::Gltf)
    uniteGltf(model);
  else
    uniteParts(model);
  if (canHold(outputName, kHoldsMeshes) && dynamic_cast<const ObjSource*>(model.source.get()))
    model.source = nullptr;  // its objects stay one
}

WrittenFiles write(const Model& model, const std::string& outputName) {
  requireWritable(outputName);
  const Format& format = *findByExtension(outputName);
  const std::string name = plainName(outputName);
  const std::vector<std::string> bodies =
      format.has(kHoldsMeshes) ? bodyNames(model) : std::vector<std::string>();
  WrittenFiles written =
      bodies.empty() ? format.write(model, name) : format.write(inBodies(model, bodies), name);
  if (!format.has(kHoldsParts) && !isOwnPly(model, format))
    for (const Warning& warning : mergedParts(model)) written.warnings.push_back(warning);
  const bool keepsMaps = model.conventions != Conventions::Gltf || format.has(kHoldsImages);
  if (const std::size_t lost = keepsMaps ? 0 : mappedGroups(model); lost > 0)
    written.warnings.push_back({"MATERIAL_IMAGES_NOT_READ",
                                "The images of the materials are not passed on: write a .glb or "
                                ".gltf to keep them.",
                                lost});
  return written;
}

std::vector<Warning> polygonsCut(const Model& model, const WrittenFiles& written) {
  const bool isCut = model.polygons > 0 && !written.isUntouched &&
                     canHold(written.files.front().name, kHoldsPolygons);
  if (!isCut) return {};
  return {{"POLYGONS_CUT",
           "Faces of more than three corners that were cut into triangles: " +
               std::to_string(model.polygons) + ". Only meshes that are all quads keep theirs.",
           model.polygons}};
}

}  // namespace remesher::io
