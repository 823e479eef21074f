// SPDX-License-Identifier: MIT
#include "io/model/dropped.h"
#include "io/named/gmsh.h"
#include "io/named/named_faces.h"
#include "io/text/text_writer.h"

namespace remesher::io {
namespace {

constexpr std::size_t kGmshTriangle = 2, kGmshQuad = 3;  // types of elements

// Between quotation marks, in one line.
std::string quoted(std::string name) {
  for (char& letter : name)
    if (letter == '"' || static_cast<unsigned char>(letter) < ' ') letter = '_';
  return '"' + name + '"';
}

// A set is a surface (an entity) and a physical group of the same number, from one.
class GmshWriter {
 public:
  explicit GmshWriter(const NamedFaces& surface)
      : surface_(surface), out_(surface.isExact ? Digits::OfDoubles : Digits::Fewest) {}

  std::vector<std::uint8_t> bytes() {
    out_.text("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    writeNames();
    writeEntities();
    writeNodes();
    writeElements();
    return out_.bytes();
  }

 private:
  void writeNames();
  void writeEntities();
  void writeNodes();
  void writeElements();

  const NamedFaces& surface_;
  TextWriter out_;
};

void GmshWriter::writeNames() {
  out_.text("$PhysicalNames\n").integer(surface_.names.size()).text("\n");
  for (std::size_t set = 0; set < surface_.names.size(); ++set)
    out_.text("2 ").integer(set + 1).text(" ").text(quoted(surface_.names[set])).text("\n");
  out_.text("$EndPhysicalNames\n");
}

void GmshWriter::writeEntities() {
  Eigen::AlignedBox3d box;
  for (const Vec3& position : surface_.positions) box.extend(position);
  out_.text("$Entities\n0 0 ").integer(surface_.names.size()).text(" 0\n");
  for (std::size_t set = 1; set <= surface_.names.size(); ++set)
    out_.integer(set).coordinates(box.min()).coordinates(box.max()).text(" 1 ").integer(set).text(
        " 0\n");
  out_.text("$EndEntities\n");
}

// All in the first entity: surfaces may share nodes along their common curves.
void GmshWriter::writeNodes() {
  const std::size_t count = surface_.positions.size();
  out_.text("$Nodes\n1 ").integer(count).text(" 1 ").integer(count).text("\n2 1 0 ");
  out_.integer(count).text("\n");
  for (std::size_t node = 1; node <= count; ++node) out_.integer(node).text("\n");
  for (const Vec3& position : surface_.positions)
    out_.coordinate(position.x())
        .text(" ")
        .coordinate(position.y())
        .text(" ")
        .coordinate(position.z())
        .text("\n");
  out_.text("$EndNodes\n");
}

void GmshWriter::writeElements() {
  const auto runs = runsOf(surface_);
  const std::size_t count = surface_.faces.size();
  out_.text("$Elements\n").integer(runs.size()).text(" ").integer(count).text(" 1 ");
  out_.integer(count).text("\n");
  std::size_t element = 0;
  for (const auto& run : runs) {
    out_.text("2 ").integer(run[0].set + 1).text(" ");
    out_.integer(run[0].count == 3 ? kGmshTriangle : kGmshQuad)
        .text(" ")
        .integer(run.size())
        .text("\n");
    for (const NamedFaces::Face& face : run) {
      out_.integer(++element);
      for (Index corner = 0; corner < face.count; ++corner)
        out_.text(" ").integer(face.corners[corner] + 1);
      out_.text("\n");
    }
  }
  out_.text("$EndElements\n");
}

}  // namespace

WrittenFiles writeGmsh(const Model& model, const std::string& outputName) {
  return {{{outputName, GmshWriter(namedFacesOf(model)).bytes()}},
          droppedAttributes(model, {kMaterial}, "Gmsh file")};
}

}  // namespace remesher::io
