// SPDX-License-Identifier: MIT
// A model that came from glTF is written into its own tree, where unchanged parts stay untouched.
// Any other model becomes a new, plain document.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/legible.h"
#include "io/gltf/gltf.h"
#include "io/gltf/gltf_accessor.h"
#include "io/gltf/gltf_document.h"
#include "io/gltf/gltf_editor.h"
#include "io/gltf/gltf_geometry.h"
#include "io/gltf/gltf_lods.h"
#include "io/gltf/gltf_materials.h"
#include "io/gltf/gltf_packing.h"
#include "io/gltf/gltf_plain.h"
#include "io/gltf/tree/gltf_extensions.h"
#include "io/gltf/tree/gltf_levels.h"
#include "io/gltf/tree/gltf_pointers.h"
#include "io/model/byte_reader.h"
#include "io/model/companions.h"
#include "io/model/resources.h"
#include "io/model/same_mesh.h"

namespace remesher::io {
namespace {

enum class Container { Text, Binary };

// The prefix of references to images that are encoded later.
constexpr std::string_view kPainting = "painting:";

// Whether the mesh equals the one in the file. The file is read again, as no copy of its mesh is
// kept, unless the vertices have another number.
bool isUntouched(const GltfDocument& document, const Part& part, int mesh) {
  std::size_t count = 0;
  for (const VertexPool& pool : vertexPools(document, std::size_t(mesh)))
    count += accessorCount(document, pool.accessors.at("POSITION"));
  if (count != part.mesh.positions.size()) return false;
  std::vector<Warning> alreadyKnown;
  const TriangleMesh read = readGeometry(document, mesh, alreadyKnown);
  return !isMended(alreadyKnown) && haveSameContent(part.mesh, read);
}

// The numbers of the replaced parts.
std::vector<std::size_t> replacedParts(const GltfDocument& document, const Model& model) {
  std::vector<std::size_t> replaced;
  for (std::size_t i = 0; i < model.parts.size(); ++i)
    if (!isUntouched(document, model.parts[i], model.parts[i].source)) replaced.push_back(i);
  return replaced;
}

bool hasLods(const Model& model) {
  return std::any_of(model.parts.begin(), model.parts.end(),
                     [](const Part& part) { return !part.lods.empty(); });
}

std::optional<std::string> imageType(const Bytes& bytes) {
  const auto hasAt = [&](std::size_t at, std::string_view magic) {
    return bytes.size() >= at + magic.size() &&
           std::equal(magic.begin(), magic.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                      [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
  };
  if (hasAt(0, "\x89PNG")) return "image/png";
  if (hasAt(0, "\xFF\xD8\xFF")) return "image/jpeg";
  if (hasAt(0, "RIFF") && hasAt(8, "WEBP")) return "image/webp";
  if (hasAt(0, "\xABKTX 20\xBB")) return "image/ktx2";
  return std::nullopt;
}

// file: where the image is, or null.
std::optional<Bytes> imageBytes(const std::string& uri, const File* file) {
  if (isDataUri(uri)) return decodeDataUri(uri);
  if (file == nullptr) return std::nullopt;
  return whole(*file).bytes;
}

// Embeds the images of a text file that becomes binary; a file used by several images is embedded
// once.
void embedImages(GltfEditor& editor, const GltfDocument& document) {
  if (!editor.tree().contains("images")) return;
  const Resources resources(document.resources);
  std::map<const File*, std::size_t> views;
  for (std::size_t i = 0; i < editor.tree()["images"].size(); ++i) {
    const Json image = editor.tree()["images"][i];
    if (!image.contains("uri")) continue;
    const std::string uri = image["uri"].get<std::string>();
    const File* const file = resources.find(uri);
    const std::optional<Bytes> bytes = imageBytes(uri, file);
    const std::optional<std::string> type = bytes ? imageType(*bytes) : std::nullopt;
    if (!type) continue;
    const auto known = views.find(file);
    const std::size_t view =
        file != nullptr && known != views.end() ? known->second : editor.addFile(*bytes);
    if (file != nullptr) views[file] = view;
    Json& changed = editor.tree()["images"][i];
    changed.erase("uri");
    changed["mimeType"] = *type;
    changed["bufferView"] = view;
  }
}

// The files that the result refers to besides its own data.
struct Companions {
  std::vector<File> files;
  std::vector<std::string> missing;  // names of missing files, as in the tree
  bool isRenamed = false;            // some files got a new name
};

// Collects the given images that the tree refers to, under plain names, and puts these names into
// the tree.
Companions takeImages(Json& tree, const std::vector<File>& resources, CompanionNames& names) {
  Companions companions;
  if (!tree.contains("images")) return companions;
  const Resources given(resources);
  std::map<const File*, std::string> nameOf;
  for (Json& image : tree["images"]) {
    if (!image.contains("uri")) continue;
    const std::string uri = image["uri"].get<std::string>();
    if (isDataUri(uri) || uri.starts_with(kPainting)) continue;
    const File* const file = given.find(uri);
    if (file == nullptr) {
      companions.missing.push_back(uri);
      continue;
    }
    const auto [entry, isNew] = nameOf.emplace(file, "");
    if (isNew) {
      entry->second = names.nameFor(uri);
      companions.files.push_back({entry->second, whole(*file).bytes});
    }
    if (entry->second == percentDecoded(uri)) continue;
    image["uri"] = referenceTo(entry->second);
    companions.isRenamed = true;
  }
  return companions;
}

// A file may name thousands of images: only the first few missing ones are listed by name.
void passOn(Companions companions, WrittenFiles& written) {
  for (File& file : companions.files) written.files.push_back(std::move(file));
  constexpr std::size_t kNamed = 8;
  const std::size_t named = std::min(kNamed, companions.missing.size());
  const auto warn = [&](const std::string& images, std::size_t count) {
    written.warnings.push_back(
        {"RESOURCE_NOT_GIVEN",
         images + " not given: the result refers to it, but it is not passed on.", count});
  };
  for (std::size_t i = 0; i < named; ++i)
    warn("The image " + legible(companions.missing[i]) + " was", 1);
  const std::size_t others = companions.missing.size() - named;
  if (others > 0) warn("Each of " + std::to_string(others) + " more images was", others);
}

// The name of the file for the data of a .gltf.
std::string dataName(const std::string& outputName, CompanionNames& names) {
  return names.nameForFile(outputName.substr(0, outputName.rfind('.')) + ".bin");
}

// dataFile: the name of the file for the data; empty: the data is embedded.
WrittenFiles serialized(PackedGltf packed, const std::string& outputName, Container container,
                        const std::string& dataFile) {
  WrittenFiles written;
  if (container == Container::Binary) {
    written.files.push_back({outputName, packGlb(packed.tree, packed.data)});
    return written;
  }
  if (!packed.data.empty())
    packed.tree["buffers"][0]["uri"] = dataFile.empty()
                                           ? encodeDataUri("application/octet-stream", packed.data)
                                           : referenceTo(dataFile);
  const std::string text = packed.tree.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  written.files.push_back({outputName, {text.begin(), text.end()}});
  if (!packed.data.empty() && !dataFile.empty())
    written.files.push_back({dataFile, std::move(packed.data)});
  return written;
}

// The file as it came, with its companions; none if a companion cannot keep its name.
std::optional<WrittenFiles> asItCame(const GltfDocument& document, const std::string& outputName) {
  CompanionNames names(outputName);
  WrittenFiles written;
  written.files.push_back({outputName, whole(document.original).bytes});
  for (const GltfBuffer& buffer : document.buffers) {
    if (buffer.name.empty()) continue;
    if (names.nameForFile(buffer.name) != buffer.name) return std::nullopt;
    written.files.push_back({buffer.name, {}});
    appendRange(written.files.back().bytes, buffer, 0, buffer.size);
  }
  Json images = {{"images", document.tree.value("images", Json::array())}};
  Companions companions = takeImages(images, document.resources, names);
  if (companions.isRenamed) return std::nullopt;
  passOn(std::move(companions), written);
  return written;
}

// Whether any primitive of a pool has an attribute.
bool hasAny(const Part& part, const VertexPool& pool, const char* semantic) {
  return std::any_of(pool.primitives.begin(), pool.primitives.end(), [&](int primitive) {
    const auto group = static_cast<std::size_t>(primitive);
    if (group >= part.groups.size()) return true;
    const std::vector<std::string>& lacks = part.groups[group].lacks;
    return std::find(lacks.begin(), lacks.end(), semantic) == lacks.end();
  });
}

// The pools of a painted part, with new accessors for the painted attributes instead of the old
// ones. Tangents are written only where the file had some: they are those that a reader makes
// where there are none.
std::vector<VertexPool> paintedPools(const Part& part, std::vector<VertexPool> pools) {
  for (VertexPool& pool : pools) {
    const bool hadTangents = pool.accessors.count("TANGENT") == 1;
    std::erase_if(pool.accessors, [&](const auto& entry) {
      const std::string own = entry.first.substr(entry.first.find('/') + 1);
      const bool isOfLook =
          own == "TANGENT" || own.starts_with("TEXCOORD_") || own.starts_with("COLOR_");
      return isOfLook && findAttribute(part.mesh, own) == nullptr;
    });
    for (const char* made : {"NORMAL", "TANGENT", "TEXCOORD_0"})
      if (findAttribute(part.mesh, made) != nullptr && hasAny(part, pool, made) &&
          (hadTangents || std::string_view(made) != "TANGENT"))
        pool.accessors[made] = -1;
  }
  return pools;
}

// Replaces materials by the paintings made of them. Returns the number of primitives that lose
// their material variants.
std::size_t usePaintings(Json& primitives, const Part& part, std::size_t firstPainting) {
  std::size_t lost = 0;
  for (std::size_t g = 0; g < part.groups.size() && g < primitives.size(); ++g) {
    if (part.groups[g].painted < 0) continue;
    primitives[g]["material"] = firstPainting + static_cast<std::size_t>(part.groups[g].painted);
    if (!primitives[g].contains("extensions")) continue;
    lost += primitives[g]["extensions"].erase("KHR_materials_variants");
    if (primitives[g]["extensions"].empty()) primitives[g].erase("extensions");
  }
  return lost;
}

bool isPaintedAnew(const Model& model) { return !model.paintings.empty() || model.hasNewTexcoords; }

// A part's mesh as the file has it, with the materials and attributes of paintings, if any.
FinestLevel finestLevel(const GltfDocument& document, const Model& model, std::size_t number,
                        std::size_t firstPainting) {
  const Part& part = model.parts[number];
  const auto mesh = static_cast<std::size_t>(part.source);
  FinestLevel finest{mesh, document.tree["meshes"][mesh], vertexPools(document, mesh),
                     Texcoords::Kept, part.coverages};
  if (!isPaintedAnew(model)) return finest;
  finest.pools = paintedPools(part, std::move(finest.pools));
  finest.texcoords = Texcoords::Painted;
  usePaintings(finest.mesh["primitives"], part, firstPainting);
  return finest;
}

bool isSkinned(const Json& tree, std::size_t mesh) {
  const Json& primitives = tree["meshes"][mesh]["primitives"];
  return std::any_of(primitives.begin(), primitives.end(), [](const Json& primitive) {
    return primitive["attributes"].contains("JOINTS_0");
  });
}

// Removes the skin from nodes of meshes that have lost their joints.
void dropSkins(Json& tree, const std::set<std::size_t>& meshes) {
  if (meshes.empty() || !tree.contains("nodes")) return;
  for (Json& node : tree["nodes"]) {
    if (!node.contains("mesh") || !isWholeNumber(node["mesh"])) continue;
    if (meshes.count(node["mesh"].get<std::size_t>()) == 1) node.erase("skin");
  }
}

// The accessors that replaced primitives used, and those that only a lost extension may have used.
Abandoned abandonedBy(GltfEditor& editor, const GltfDocument& document) {
  Abandoned abandoned{editor.abandoned(), {}};
  if (!document.tree.contains("accessors")) return abandoned;
  for (const int accessor : editor.lost().accessors)
    if (static_cast<std::size_t>(accessor) < document.tree["accessors"].size())
      abandoned.accessors.insert(accessor);
  return abandoned;
}

WrittenFiles writeDocument(const GltfDocument& document, const Model& model,
                           const std::string& outputName, Container container) {
  const Container before = document.isBinary ? Container::Binary : Container::Text;
  const std::vector<std::size_t> replaced = replacedParts(document, model);
  if (replaced.empty() && container == before && !hasLods(model) && !model.replacesLevels &&
      model.leftOut.empty() && document.isGiven)
    if (std::optional<WrittenFiles> same = asItCame(document, outputName)) return std::move(*same);

  GltfEditor editor(document.tree, &document);
  const std::set<std::size_t> oldLevels =
      model.replacesLevels ? takeLevels(editor.tree()) : std::set<std::size_t>();
  const bool isPainted = isPaintedAnew(model);
  const std::size_t firstPainting = isPainted ? addPaintings(editor.tree(), model) : 0;
  std::size_t lostVariants = 0;
  std::set<std::size_t> jointless;
  LodWriter levels(editor);
  std::map<std::size_t, std::vector<std::size_t>> shared;  // by part: the meshes of its levels
  for (const std::size_t i : replaced) {
    const auto mesh = static_cast<std::size_t>(model.parts[i].source);
    std::vector<VertexPool> pools = vertexPools(document, mesh);
    if (isPainted) {
      pools = paintedPools(model.parts[i], std::move(pools));
      lostVariants +=
          usePaintings(editor.tree()["meshes"][mesh]["primitives"], model.parts[i], firstPainting);
    }
    shared[i] = levels.addShared(finestLevel(document, model, i, firstPainting),
                                 model.parts[i].mesh, model.parts[i].lods);
    if (shared[i].empty())
      editor.replaceGeometry(mesh, model.parts[i].mesh, pools,
                             isPainted ? Texcoords::Painted : Texcoords::Kept);
    if (isSkinned(document.tree, mesh) && !isSkinned(editor.tree(), mesh)) jointless.insert(mesh);
  }
  dropSkins(editor.tree(), jointless);
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    if (model.parts[i].lods.empty()) continue;
    const FinestLevel finest = finestLevel(document, model, i, firstPainting);
    if (shared[i].empty())
      levels.add(finest, model.parts[i].lods);
    else
      levels.addNodes(finest, shared[i]);
  }
  editor.lost().accessors.merge(dropNodes(editor.tree(), oldLevels));
  settlePointers(document.tree, editor.tree(), editor.lost());
  editor.lost().accessors.merge(
      dropMeshes(editor.tree(), {model.leftOut.begin(), model.leftOut.end()}));
  Abandoned abandoned = abandonedBy(editor, document);
  if (isPainted) {
    dropUnusedVariants(editor.tree());
    abandoned.bufferViews = dropUnusedLooks(editor.tree());
  }
  settleDeclarations(document.tree, editor.tree());
  if (container == Container::Binary && before == Container::Text) embedImages(editor, document);
  std::vector<GltfBuffer> buffers = document.buffers;
  buffers.push_back(editor.newData());
  PackedGltf packed = packGltf(std::move(editor.tree()), buffers, abandoned);
  CompanionNames names(outputName);
  const std::string dataFile = document.isEmbedded ? "" : dataName(outputName, names);
  Companions images = takeImages(packed.tree, document.resources, names);
  WrittenFiles written = serialized(std::move(packed), outputName, container, dataFile);
  written.images = model.images;
  written.warnings = warningsOf(editor.lost());
  if (lostVariants > 0)
    written.warnings.push_back(
        {"MAP_NOT_PAINTED", "Variants of materials cannot be baked and are lost.", lostVariants});
  passOn(std::move(images), written);
  return written;
}

WrittenFiles writePlain(const Model& model, const std::string& outputName, Container container) {
  CompanionNames names(outputName);
  WrittenFiles written =
      serialized(plainGltf(model), outputName, container, dataName(outputName, names));
  written.images = model.images;
  return written;
}

WrittenFiles writeIn(const Model& model, const std::string& outputName, Container container) {
  const auto* const document = dynamic_cast<const GltfDocument*>(model.source.get());
  try {
    return document == nullptr ? writePlain(model, outputName, container)
                               : writeDocument(*document, model, outputName, container);
  } catch (const Json::exception&) {
    throw Error(ErrorCode::ParseError, "The glTF document is invalid and cannot be written back.",
                "A glTF validator tells where.");
  }
}

}  // namespace

WrittenFiles writeGltf(const Model& model, const std::string& outputName) {
  return writeIn(model, outputName, Container::Text);
}

WrittenFiles writeGlb(const Model& model, const std::string& outputName) {
  return writeIn(model, outputName, Container::Binary);
}

}  // namespace remesher::io
