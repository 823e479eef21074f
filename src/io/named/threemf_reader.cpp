// SPDX-License-Identifier: MIT
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/legible.h"
#include "io/model/byte_reader.h"
#include "io/model/conventions.h"
#include "io/model/resources.h"
#include "io/named/threemf.h"
#include "io/text/text_scanner.h"
#include "io/text/xml_scanner.h"

namespace remesher::io {
namespace {

struct PlacedObject {
  std::string object;  // its key
  Transform place = Transform::Identity();
};

struct PackageObject {
  std::string name;
  TriangleMesh mesh;
  std::vector<GroupInfo> groups;
  std::vector<PlacedObject> components;
};

// Materials and colours by the number of their list and their place in it.
using MaterialKey = std::pair<std::string, std::string>;

// #RRGGBB or #RRGGBBAA, in sRGB.
std::optional<Eigen::Vector4d> colorFrom(const std::string& text) {
  if ((text.size() != 7 && text.size() != 9) || text[0] != '#') return std::nullopt;
  Eigen::Vector4d color = Eigen::Vector4d::Ones();
  constexpr double kWhite = 255;
  for (std::size_t i = 0; 2 * i + 2 < text.size(); ++i) {
    int value = 0;
    const char* const begin = &text[2 * i + 1];
    if (std::from_chars(begin, begin + 2, value, 16).ptr != begin + 2) return std::nullopt;
    const double fraction = value / kWhite;
    color[static_cast<Eigen::Index>(i)] = i < 3 ? linearFromSrgb(fraction) : fraction;
  }
  return color;
}

class PackageReader {
 public:
  explicit PackageReader(const std::vector<File>& resources) : resources_(resources) {}
  Model read(const File& file);

 private:
  void readModel(std::string_view text, const std::string& path);
  void readObject(XmlScanner& xml, const XmlTag& opened, const std::string& path);
  void readMaterial(const XmlTag& tag, const std::string& list, std::size_t number);
  Index groupOf(PackageObject& object, const MaterialKey& key);
  void readTriangle(const XmlScanner& xml, const XmlTag& tag, PackageObject& object,
                    const MaterialKey& usual);
  PlacedObject componentIn(const XmlScanner& xml, const XmlTag& tag, const std::string& path);
  void place(const std::string& key, const Transform& transform, int depth);

  Resources resources_;
  std::string unit_ = "millimeter";
  std::map<std::string, PackageObject> objects_;  // by path and number
  std::vector<std::string> order_;                // of those with a mesh
  std::map<std::string, std::vector<Transform>> places_;
  std::map<MaterialKey, GroupInfo> materials_;
  std::vector<PlacedObject> items_;  // of the build
  std::set<std::string> read_;       // paths of models
};

double numberOf(const XmlScanner& xml, const XmlTag& tag, std::string_view name) {
  const std::string* const text = tag.find(name);
  const std::optional<double> value = text ? TextScanner::numberIn(*text) : std::nullopt;
  if (!value)
    xml.fail(ErrorCode::ParseError,
             "<" + legible(tag.name) + "> has no number " + std::string(name) + ".");
  if (!std::isfinite(*value))
    xml.fail(ErrorCode::NonFinite, std::string(name) + " is not finite.",
             "Repair the file: every coordinate must be a finite number.");
  return *value;
}

Transform transformOf(const XmlScanner& xml, const XmlTag& tag) {
  Transform transform = Transform::Identity();
  const std::string* const text = tag.find("transform");
  if (text == nullptr) return transform;
  TextScanner numbers(*text, "transform");
  numbers.nextLine();
  // The rows of a matrix that a row vector is multiplied with: the columns of ours.
  for (Eigen::Index row = 0; row < 4; ++row)
    for (Eigen::Index column = 0; column < 3; ++column) {
      if (!numbers.skipEmptyLines())
        xml.fail(ErrorCode::ParseError, "a transform has fewer than twelve numbers.");
      transform.matrix()(column, row) = numbers.number("a number of a transform");
    }
  return transform;
}

PlacedObject PackageReader::componentIn(const XmlScanner& xml, const XmlTag& tag,
                                        const std::string& path) {
  const std::string* const elsewhere = tag.find("path");
  std::string from = elsewhere == nullptr ? path : *elsewhere;
  if (elsewhere != nullptr && read_.insert(from).second) {
    const std::string inside = from.starts_with('/') ? from.substr(1) : from;
    const File* const file = resources_.find(inside);
    if (file == nullptr)
      xml.fail(ErrorCode::MissingResource, "the package lacks " + legible(inside) + ".",
               "Was it copied completely?");
    readModel(asText(whole(*file)), from);
  }
  return {from + '#' + tag.get("objectid"), transformOf(xml, tag)};
}

void PackageReader::readMaterial(const XmlTag& tag, const std::string& list, std::size_t number) {
  GroupInfo info;
  info.material = tag.get("name");
  const std::string color = tag.get(tag.name == "base" ? "displaycolor" : "color");
  if (info.material.empty()) info.material = color;
  info.look.name = info.material;
  if (const auto value = colorFrom(color)) info.look.baseColor = *value;
  materials_[{list, std::to_string(number)}] = info;
}

Index PackageReader::groupOf(PackageObject& object, const MaterialKey& key) {
  const auto found = materials_.find(key);
  const GroupInfo info = found == materials_.end() ? GroupInfo{} : found->second;
  for (Index group = 0; group < object.groups.size(); ++group)
    if (object.groups[group].material == info.material) return group;
  object.groups.push_back(info);
  return static_cast<Index>(object.groups.size() - 1);
}

void PackageReader::readTriangle(const XmlScanner& xml, const XmlTag& tag, PackageObject& object,
                                 const MaterialKey& usual) {
  for (const std::string_view corner : {"v1", "v2", "v3"}) {
    const double vertex = numberOf(xml, tag, corner);
    if (!(vertex >= 0 && vertex < double(object.mesh.positions.size())))
      xml.fail(ErrorCode::IndexOutOfRange,
               "a triangle names vertex " + inDigits(vertex, 17) + ", but there are " +
                   std::to_string(object.mesh.positions.size()) + ", counted from 0.",
               "Repair the file: every triangle may name only vertices that are there.");
    object.mesh.indices.push_back(static_cast<Index>(vertex));
  }
  const bool isOwn = tag.find("p1") != nullptr;
  const std::string* const list = tag.find("pid");
  object.mesh.groups.push_back(groupOf(
      object, {list == nullptr ? usual.first : *list, isOwn ? tag.get("p1") : usual.second}));
}

void PackageReader::readObject(XmlScanner& xml, const XmlTag& opened, const std::string& path) {
  const std::string key = path + '#' + opened.get("id");
  const MaterialKey usual{opened.get("pid"), opened.get("pindex")};
  PackageObject object;
  object.name = opened.get("name");
  while (const std::optional<XmlTag> tag = xml.next()) {
    if (tag->name == "object" && tag->closes) break;
    if (!tag->opens) continue;
    if (tag->name == "vertex")
      object.mesh.positions.emplace_back(numberOf(xml, *tag, "x"), numberOf(xml, *tag, "y"),
                                         numberOf(xml, *tag, "z"));
    if (tag->name == "triangle") readTriangle(xml, *tag, object, usual);
    if (tag->name == "component") object.components.push_back(componentIn(xml, *tag, path));
  }
  if (object.groups.size() == 1 && object.groups[0].material.empty()) {
    object.groups.clear();
    object.mesh.groups.clear();
  }
  if (!object.mesh.indices.empty()) order_.push_back(key);
  objects_[key] = std::move(object);
}

void PackageReader::readModel(std::string_view text, const std::string& path) {
  XmlScanner xml(text, path);
  std::string list;
  std::size_t number = 0;
  const bool isMain = read_.size() == 1;
  while (const std::optional<XmlTag> tag = xml.next()) {
    if (!tag->opens) continue;
    if (tag->name == "model" && isMain && tag->find("unit") != nullptr) unit_ = tag->get("unit");
    if (tag->name == "basematerials" || tag->name == "colorgroup") {
      list = tag->get("id");
      number = 0;
    }
    if (tag->name == "base" || tag->name == "color") readMaterial(*tag, list, number++);
    if (tag->name == "object" && !tag->closes) readObject(xml, *tag, path);
    if (tag->name == "item" && isMain) items_.push_back(componentIn(xml, *tag, path));
  }
}

void PackageReader::place(const std::string& key, const Transform& transform, int depth) {
  constexpr int kDeepest = 64;  // a component may not hold itself
  const auto found = objects_.find(key);
  if (found == objects_.end() || depth > kDeepest) return;
  if (!found->second.mesh.indices.empty()) places_[key].push_back(transform);
  for (const PlacedObject& component : found->second.components)
    place(component.object, transform * component.place, depth + 1);
}

Model PackageReader::read(const File& file) {
  read_.insert(file.name);
  readModel(asText(file), file.name);
  for (const PlacedObject& item : items_) place(item.object, item.place, 0);
  Model model;
  model.conventions = Conventions::Classic;
  model.unit = unit_;
  for (const std::string& key : order_) {
    if (places_[key].empty()) continue;
    PackageObject& object = objects_[key];
    model.parts.push_back(
        {object.name, std::move(object.mesh), std::move(places_[key]), std::move(object.groups)});
  }
  if (model.parts.empty())
    throw Error(ErrorCode::NoTriangles, legible(file.name) + " shows no triangles.",
                "Its build has no item with a mesh.");
  return model;
}

}  // namespace

Model readThreemf(const File& file, const std::vector<File>& resources) {
  return PackageReader(resources).read(file);
}

}  // namespace remesher::io
