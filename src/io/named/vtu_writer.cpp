// SPDX-License-Identifier: MIT
#include "io/model/dropped.h"
#include "io/named/named_faces.h"
#include "io/named/vtu.h"
#include "io/text/text_writer.h"

namespace remesher::io {
namespace {

void beginArray(TextWriter& out, std::string_view type, std::string_view name,
                std::string_view others = "") {
  out.text("<DataArray type=\"").text(type).text("\" Name=\"").text(name).text("\"");
  out.text(others).text(" format=\"ascii\">\n");
}

void endArray(TextWriter& out) { out.text("</DataArray>\n"); }

// VTK keeps texts as the numbers of their letters, each with a zero behind it.
void writeNames(TextWriter& out, const NamedFaces& surface) {
  out.text("<FieldData>\n");
  beginArray(out, "String", "groupNames",
             " NumberOfTuples=\"" + std::to_string(surface.names.size()) + "\"");
  for (const std::string& name : surface.names) {
    for (const char letter : name) out.integer(static_cast<unsigned char>(letter)).text(" ");
    out.text("0\n");
  }
  endArray(out);
  out.text("</FieldData>\n");
}

void writeCells(TextWriter& out, const NamedFaces& surface) {
  out.text("<Cells>\n");
  beginArray(out, "Int64", "connectivity");
  for (const NamedFaces::Face& face : surface.faces)
    for (Index corner = 0; corner < face.count; ++corner)
      out.integer(face.corners[corner]).text(corner + 1 < face.count ? " " : "\n");
  endArray(out);
  beginArray(out, "Int64", "offsets");
  std::size_t end = 0;
  for (const NamedFaces::Face& face : surface.faces) out.integer(end += face.count).text("\n");
  endArray(out);
  beginArray(out, "UInt8", "types");
  for (const NamedFaces::Face& face : surface.faces)
    out.integer(face.count == 3 ? kVtkTriangle : kVtkQuad).text("\n");
  endArray(out);
  out.text("</Cells>\n");
}

std::vector<std::uint8_t> vtuBytes(const NamedFaces& surface) {
  TextWriter out(surface.isExact ? Digits::OfDoubles : Digits::Fewest);
  out.text("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" ");
  out.text("byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n");
  writeNames(out, surface);
  out.text("<Piece NumberOfPoints=\"").integer(surface.positions.size());
  out.text("\" NumberOfCells=\"").integer(surface.faces.size()).text("\">\n<Points>\n");
  beginArray(out, surface.isExact ? "Float64" : "Float32", "Points", " NumberOfComponents=\"3\"");
  for (const Vec3& position : surface.positions)
    out.coordinate(position.x())
        .text(" ")
        .coordinate(position.y())
        .text(" ")
        .coordinate(position.z())
        .text("\n");
  endArray(out);
  out.text("</Points>\n");
  writeCells(out, surface);
  out.text("<CellData Scalars=\"group\">\n");
  beginArray(out, "Int32", "group");
  for (const NamedFaces::Face& face : surface.faces) out.integer(face.set).text("\n");
  endArray(out);
  out.text("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  return out.bytes();
}

}  // namespace

WrittenFiles writeVtu(const Model& model, const std::string& outputName) {
  return {{{outputName, vtuBytes(namedFacesOf(model))}},
          droppedAttributes(model, {kMaterial}, "VTU file")};
}

}  // namespace remesher::io
