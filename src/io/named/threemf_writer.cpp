// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "io/model/bake.h"
#include "io/model/conventions.h"
#include "io/model/corner_weld.h"
#include "io/model/dropped.h"
#include "io/model/units.h"
#include "io/named/threemf.h"
#include "io/text/text_writer.h"

namespace remesher::io {
namespace {

constexpr std::string_view kNamespace = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += static_cast<unsigned char>(c) < ' ' ? '_' : c;
  }
  return result;
}

// #RRGGBBAA in sRGB.
std::string colorText(const Eigen::Vector4d& color) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string text = "#";
  for (Eigen::Index i = 0; i < 4; ++i) {
    const double value = std::clamp(color[i], 0.0, 1.0);
    const auto byte =
        static_cast<unsigned>(std::lround(255 * (i < 3 ? srgbFromLinear(value) : value)));
    text.append({kHex[byte >> 4], kHex[byte & 15]});
  }
  return text;
}

// Numbers of the XML's resources are positive: the list of materials is 1, the objects follow.
class ThreemfWriter {
 public:
  ThreemfWriter(std::string_view unit, Digits digits) : out_(digits) {
    out_.text("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"").text(unit);
    out_.text("\" xml:lang=\"en-US\" xmlns=\"").text(kNamespace).text("\">\n");
    out_.text("<metadata name=\"Application\">remesher</metadata>\n<resources>\n");
  }
  void writeMaterials(const std::vector<Part>& bodies);
  void writeObject(const Part& body);
  std::vector<std::uint8_t> finish();

 private:
  std::size_t materialOf(const Part& body, Index group) const;

  TextWriter out_;
  std::vector<std::string> materials_;
  std::size_t objects_ = 0;
};

constexpr std::size_t kNoMaterial = ~std::size_t{0};

void ThreemfWriter::writeMaterials(const std::vector<Part>& bodies) {
  std::string list;
  for (const Part& body : bodies)
    for (const GroupInfo& group : body.groups) {
      if (group.material.empty() ||
          std::find(materials_.begin(), materials_.end(), group.material) != materials_.end())
        continue;
      materials_.push_back(group.material);
      list += "<base name=\"" + escaped(group.material) + "\" displaycolor=\"" +
              colorText(group.look.baseColor) + "\"/>\n";
    }
  if (!list.empty()) out_.text("<basematerials id=\"1\">\n").text(list).text("</basematerials>\n");
}

std::size_t ThreemfWriter::materialOf(const Part& body, Index group) const {
  if (group >= body.groups.size()) return kNoMaterial;
  const auto found = std::find(materials_.begin(), materials_.end(), body.groups[group].material);
  return found == materials_.end() ? kNoMaterial : std::size_t(found - materials_.begin());
}

void ThreemfWriter::writeObject(const Part& body) {
  const TriangleMesh& mesh = body.mesh;
  CornerWeld weld;
  std::vector<Index> points, corners;
  for (const Vec3& position : mesh.positions) points.push_back(weld.vertexAt(position));
  for (const Index vertex : mesh.indices) corners.push_back(points[vertex]);
  const std::size_t usual = mesh.groups.empty() ? materialOf(body, 0) : kNoMaterial;
  out_.text("<object id=\"").integer(++objects_ + 1).text("\" type=\"model\"");
  if (!body.name.empty()) out_.text(" name=\"").text(escaped(body.name)).text("\"");
  if (usual != kNoMaterial) out_.text(" pid=\"1\" pindex=\"").integer(usual).text("\"");
  out_.text(">\n<mesh>\n<vertices>\n");
  for (const Vec3& position : weld.positions()) {
    out_.text("<vertex x=\"").coordinate(position.x()).text("\" y=\"").coordinate(position.y());
    out_.text("\" z=\"").coordinate(position.z()).text("\"/>\n");
  }
  out_.text("</vertices>\n<triangles>\n");
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    // The specification forbids triangles that name a vertex twice.
    if (corners[i] == corners[i + 1] || corners[i + 1] == corners[i + 2] ||
        corners[i + 2] == corners[i])
      continue;
    out_.text("<triangle v1=\"").integer(corners[i]).text("\" v2=\"").integer(corners[i + 1]);
    out_.text("\" v3=\"").integer(corners[i + 2]);
    const std::size_t own =
        mesh.groups.empty() ? kNoMaterial : materialOf(body, mesh.groups[i / 3]);
    if (own != kNoMaterial) out_.text("\" pid=\"1\" p1=\"").integer(own);
    out_.text("\"/>\n");
  }
  out_.text("</triangles>\n</mesh>\n</object>\n");
}

std::vector<std::uint8_t> ThreemfWriter::finish() {
  out_.text("</resources>\n<build>\n");
  for (std::size_t object = 1; object <= objects_; ++object)
    out_.text("<item objectid=\"").integer(object + 1).text("\"/>\n");
  out_.text("</build>\n</model>\n");
  return out_.bytes();
}

}  // namespace

WrittenFiles writeThreemf(const Model& model, const std::string& outputName) {
  const std::vector<Part> bodies = bakeInstances(model);
  std::vector<const TriangleMesh*> meshes;
  for (const Part& body : bodies) meshes.push_back(&body.mesh);
  const std::string unit = unitOf(model);
  ThreemfWriter writer(unit.empty() ? "millimeter" : unit,
                       digitsFor(meshes, model.isExact ? Digits::OfDoubles : Digits::Fewest));
  writer.writeMaterials(bodies);
  for (const Part& body : bodies) writer.writeObject(body);
  return {{{outputName, writer.finish()}}, droppedAttributes(model, {kMaterial}, "3MF file")};
}

}  // namespace remesher::io
