// SPDX-License-Identifier: MIT
#include "io/ply/ply_layout.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/model/near_origin.h"

namespace remesher::io {
namespace {

// Names that mean a semantic if all of them are present. For each semantic the first matching row
// counts; the names of its first row are written.
struct KnownNames {
  std::string_view semantic;
  std::array<std::string_view, 4> names;  // one per component

  std::size_t width() const {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), "") - names.begin());
  }
};

constexpr std::array<KnownNames, 10> kKnown = {{
    {"POSITION", {"x", "y", "z"}},
    {"NORMAL", {"nx", "ny", "nz"}},
    {"COLOR_0", {"red", "green", "blue", "alpha"}},
    {"COLOR_0", {"red", "green", "blue"}},
    {"COLOR_0", {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}},
    {"COLOR_0", {"diffuse_red", "diffuse_green", "diffuse_blue"}},
    {"COLOR_0", {"r", "g", "b"}},
    {"TEXCOORD_0", {"s", "t"}},
    {"TEXCOORD_0", {"u", "v"}},
    {"TEXCOORD_0", {"texture_u", "texture_v"}},
}};

PlyField* find(std::vector<PlyField>& fields, std::string_view name) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const PlyField& field) {
    return field.property.name == name && !field.property.countType;
  });
  return found == fields.end() ? nullptr : &*found;
}

// Integer colours range to 255, whatever type holds them, except for 16-bit unsigned ones.
double oneOf(std::string_view semantic, PlyType type) {
  if (semantic != "COLOR_0" || isFloating(type)) return 1;
  return type == PlyType::UInt16 ? 65535 : 255;
}

void assign(std::vector<PlyField>& fields, const KnownNames& known) {
  const auto width = static_cast<int>(known.width());
  for (int i = 0; i < width; ++i)
    if (find(fields, known.names[i]) == nullptr) return;
  for (int i = 0; i < width; ++i) {
    PlyField& field = *find(fields, known.names[i]);
    field.semantic = known.semantic;
    field.component = i;
    field.one = oneOf(known.semantic, field.property.type);
  }
}

bool hasLower(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

bool hasUpper(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

std::string turned(std::string text, char from, char to) {
  for (char& c : text)
    if (c >= from && c < from + 26) c = static_cast<char>(c - from + to);
  return text;
}

// glTF's custom attributes begin with an underscore and are usually in capitals.
std::string customSemantic(const std::vector<PlyField>& fields, const std::string& name) {
  std::string semantic = "_" + (hasUpper(name) ? name : turned(name, 'a', 'A'));
  while (widthOf(fields, semantic) > 0) semantic.insert(0, "_");
  return semantic;
}

// The inverse, as a single word.
std::string customName(const std::string& semantic) {
  std::string name = semantic.substr(1);
  if (!hasLower(name)) name = turned(name, 'A', 'a');
  for (char& c : name)
    if (c <= ' ' || c == '#' || c == '\\') c = '_';
  return name;
}

// Single precision, if the positions are rounded to it, or if it can hold them and their shape.
PlyType positionType(const TriangleMesh& mesh) {
  const bool areSmall = std::all_of(mesh.positions.begin(), mesh.positions.end(),
                                    [](const Vec3& p) { return p.cast<float>().allFinite(); });
  return areSmall && (mesh.isSingle || !isFarFromOrigin(mesh)) ? PlyType::Float32
                                                               : PlyType::Float64;
}

void append(std::vector<PlyField>& fields, const KnownNames& known, PlyType type) {
  for (std::size_t i = 0; i < known.width(); ++i)
    fields.push_back({{std::string(known.names[i]), type},
                      std::string(known.semantic),
                      static_cast<int>(i),
                      oneOf(known.semantic, type)});
}

// A name that is taken keeps its underscore: _X is not the coordinate x.
void appendCustom(std::vector<PlyField>& fields, const Attribute& attribute) {
  const std::string bare = customName(attribute.semantic);
  for (int i = 0; i < attribute.itemSize; ++i) {
    const std::string suffix = attribute.itemSize > 1 ? "_" + std::to_string(i) : "";
    std::string name = bare + suffix;
    const auto isKnown = [&](std::string_view reserved) { return reserved == name; };
    const bool isReserved = std::any_of(kKnown.begin(), kKnown.end(), [&](const KnownNames& known) {
      return std::any_of(known.names.begin(), known.names.end(), isKnown);
    });
    if (isReserved) name.insert(0, "_");
    while (find(fields, name) != nullptr) name.insert(0, "_");
    fields.push_back({{name, PlyType::Float32}, attribute.semantic, i, 1});
  }
}

}  // namespace

int widthOf(const std::vector<PlyField>& fields, const std::string& semantic) {
  return static_cast<int>(std::count_if(fields.begin(), fields.end(), [&](const PlyField& field) {
    return field.semantic == semantic;
  }));
}

std::vector<PlyField> fieldsOf(const PlyElement& vertex) {
  std::vector<PlyField> fields;
  for (const PlyProperty& property : vertex.properties) fields.push_back({property, ""});
  for (const KnownNames& known : kKnown)
    if (widthOf(fields, std::string(known.semantic)) == 0) assign(fields, known);
  for (PlyField& field : fields)
    if (field.semantic.empty() && !field.property.countType)
      field.semantic = customSemantic(fields, field.property.name);
  return fields;
}

std::vector<PlyField> fieldsFor(const TriangleMesh& mesh) {
  std::vector<PlyField> fields;
  append(fields, kKnown[0], positionType(mesh));
  for (const KnownNames& known : kKnown) {
    const std::string semantic(known.semantic);
    const Attribute* const attribute = findAttribute(mesh, semantic);
    if (attribute == nullptr || widthOf(fields, semantic) > 0 ||
        attribute->itemSize != static_cast<int>(known.width()))
      continue;
    append(fields, known, semantic == "COLOR_0" ? PlyType::UInt8 : PlyType::Float32);
  }
  for (const Attribute& attribute : mesh.attributes)
    if (attribute.semantic.starts_with("_")) appendCustom(fields, attribute);
  return fields;
}

}  // namespace remesher::io
