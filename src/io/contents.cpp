// SPDX-License-Identifier: MIT
// Sources: the first bytes that each format's specification fixes.
#include "io/contents.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "io/model/byte_reader.h"
#include "io/model/resources.h"
#include "io/ply/ply.h"
#include "io/ply/ply_header.h"
#include "io/stl/stl.h"
#include "io/text/off.h"
#include "io/text/text_scanner.h"

namespace remesher::io {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kExport = "Export it as GLB, OBJ, PLY or STL.";
constexpr std::string_view kUnpack = "Unpack it, and give the model that is inside.";
constexpr std::string_view kNoModel = "Give the model itself.";
constexpr std::string_view kDownload = "The download went wrong: download the model itself.";

struct Magic {
  std::size_t at;  // its first byte
  std::string_view bytes;
  Content content;
};

constexpr Magic kMagics[] = {
    {0, "glTF", {".glb", {}, {}}},
    {0, "Kaydara FBX Binary", {{}, "an FBX file", kExport}},
    {0, "; FBX ", {{}, "an FBX file", kExport}},
    {0, "ISO-10303-21", {{}, "a STEP file", kExport}},
    {72, "S      1", {{}, "an IGES file", kExport}},
    {0, "BLENDER", {{}, "a Blender file", kExport}},
    {0, "PXR-USDC", {{}, "a USD file", kExport}},
    {0, "#usda", {{}, "a USD file", kExport}},
    {0, "Ogawa\xFF", {{}, "an Alembic file", kExport}},
    {0, "#VRML", {{}, "a VRML file", kExport}},
    {0, "#Inventor", {{}, "an Open Inventor file", kExport}},
    {0, "# vtk DataFile Version", {{}, "a VTK file", kExport}},
    {0, "# .PCD", {{}, "a cloud of points (PCD)", kExport}},
    {0, "LASF", {{}, "a cloud of points (LAS)", kExport}},
    {0, "ASTM-E57", {{}, "a cloud of points (E57)", kExport}},
    {0, "3D Geometry File Format", {{}, "a Rhino file", kExport}},
    {0, "**ABCDEFGHIJKLMNOPQRSTUVWXYZ", {{}, "a Parasolid file", kExport}},
    {0, "//Maya ASCII", {{}, "a Maya file", kExport}},
    {0, "$MeshFormat", {".msh", {}, {}}},
    {0, "DRACO", {{}, "a Draco file without its glTF", kExport}},
    {0, "Rar!\x1A\x07", {{}, "a RAR archive", kUnpack}},
    {0, "7z\xBC\xAF\x27\x1C", {{}, "a 7-Zip archive", kUnpack}},
    {0, "\x1F\x8B\x08"sv, {{}, "a gzip archive", kUnpack}},
    {0,
     "\xFD"
     "7zXZ",
     {{}, "an xz archive", kUnpack}},
    {0, "BZh", {{}, "a bzip2 archive", kUnpack}},
    {0, "\x28\xB5\x2F\xFD", {{}, "a Zstandard archive", kUnpack}},
    {257, "ustar", {{}, "a tar archive", kUnpack}},
    {0, "\x89PNG", {{}, "a picture (PNG)", kNoModel}},
    {0, "\xFF\xD8\xFF", {{}, "a picture (JPEG)", kNoModel}},
    {0, "GIF8", {{}, "a picture (GIF)", kNoModel}},
    {8, "WEBP", {{}, "a picture (WebP)", kNoModel}},
    {0, "II*\0"sv, {{}, "a picture (TIFF)", kNoModel}},
    {0, "MM\0*"sv, {{}, "a picture (TIFF)", kNoModel}},
    {0, "\xABKTX ", {{}, "a picture (KTX)", kNoModel}},
    {0, "DDS ", {{}, "a picture (DDS)", kNoModel}},
    {0, "8BPS", {{}, "a picture (PSD)", kNoModel}},
    {0, "\x76\x2F\x31\x01", {{}, "a picture (OpenEXR)", kNoModel}},
    {0, "#?RADIANCE", {{}, "a picture (HDR)", kNoModel}},
    {0, "%PDF", {{}, "a PDF document", kNoModel}},
    {0,
     "version https://git-lfs",
     {{}, "a pointer of Git LFS, not the file it stands for", "Fetch that with git lfs pull."}},
};

// Formats by the beginning of a text in angle brackets; the first match counts.
constexpr Magic kMarkup[] = {
    {0, "<html", {{}, "a web page (HTML)", kDownload}},
    {0, "<!doctype html", {{}, "a web page (HTML)", kDownload}},
    {0, "<head", {{}, "a web page (HTML)", kDownload}},
    {0, "<collada", {{}, "a COLLADA file", kExport}},
    {0, "<x3d", {{}, "an X3D file", kExport}},
    {0, "<amf", {{}, "an AMF file", kExport}},
    {0, "<svg", {{}, "a drawing (SVG)", kNoModel}},
    {0, "<vtkfile type=\"unstructuredgrid", {".vtu", {}, {}}},
    {0, "<vtkfile type=\"polydata", {".vtu", {}, {}}},
    {0, "<vtkfile", {{}, "a VTK file", kExport}},
    {0, "<model", {".3mf", {}, {}}},
};

constexpr std::size_t kBytesLooked = 4096;  // at the beginning, where a format shows itself

bool holdsAt(std::string_view bytes, const Magic& magic) {
  return bytes.size() >= magic.at && bytes.substr(magic.at).starts_with(magic.bytes);
}

std::uint32_t numberAt(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return number;
}

// Exactly as long as its number of facets says, which no other file is by chance.
bool isBinaryStl(std::string_view begin, std::uint64_t size) {
  if (begin.size() <= kFacetsAt) return false;
  return size == kFacetsAt + std::uint64_t{kFacetBytes} * numberAt(begin, kHeaderBytes);
}

bool isTextStl(std::string_view text) {
  const std::string begin = lowerCase(text.substr(0, kBytesLooked));
  return begin.starts_with("solid") && begin.find('\0') == begin.npos &&
         (begin.find("facet") != begin.npos || begin.find("endsolid") != begin.npos);
}

bool isNumberWord(std::string_view word) {
  return !word.empty() && "+-.0123456789"sv.find(word[0]) != std::string_view::npos;
}

// A text of OBJ's statements only, as far as is looked, with a vertex among them.
bool isObj(std::string_view text) {
  constexpr std::array kOthers = {"vt"sv, "vn"sv, "vp"sv, "f"sv,      "l"sv,     "p"sv,
                                  "o"sv,  "g"sv,  "s"sv,  "mtllib"sv, "usemtl"sv};
  constexpr int kStatements = 1000;
  TextScanner scanner(text, "");
  for (int i = 0; i < kStatements && scanner.nextLine();) {
    if (scanner.atLineEnd()) continue;
    const std::string_view keyword = scanner.word();
    if (keyword == "v")
      return isNumberWord(scanner.word()) && isNumberWord(scanner.word()) &&
             isNumberWord(scanner.word());
    if (std::find(kOthers.begin(), kOthers.end(), keyword) == kOthers.end()) return false;
    ++i;
  }
  return false;
}

bool isDxf(std::string_view text) {
  TextScanner scanner(text, "");
  if (!scanner.nextLine() || scanner.word() != "0" || !scanner.nextLine()) return false;
  return scanner.word() == "SECTION";
}

// Formats whose first bytes are few hold their own length behind them.
bool saysLength(std::string_view bytes, std::string_view magic) {
  return bytes.size() >= 6 && bytes.starts_with(magic) && numberAt(bytes, 2) == bytes.size();
}

// The names of what is inside stand at both ends.
Content contentOfZip(std::string_view bytes) {
  const auto holds = [&](std::string_view name) {
    constexpr std::size_t kEnds = 65536;
    return bytes.substr(0, kEnds).find(name) != bytes.npos ||
           bytes.substr(bytes.size() - std::min(bytes.size(), kEnds)).find(name) != bytes.npos;
  };
  if (holds("3D/3dmodel.model"))
    return {{}, "a 3MF package", "Unpack it, and give its 3D/3dmodel.model."};
  if (holds(".usdc") || holds(".usda")) return {{}, "a USDZ file", kExport};
  return {{}, "a ZIP archive", kUnpack};
}

Content contentOfMarkup(std::string_view text) {
  const std::string begin = lowerCase(text.substr(0, kBytesLooked));
  for (const Magic& magic : kMarkup)
    if (begin.find(magic.bytes) != begin.npos) return magic.content;
  return {{}, "a text in XML, as servers answer with", kDownload};
}

Content contentOfJson(std::string_view text) {
  if (text.find("\"asset\"") != text.npos) return {".gltf", {}, {}};
  return {{}, "a text in JSON without a glTF's \"asset\"", kDownload};
}

std::string_view withoutMarkAndBlanks(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text;
}

Content contentOfText(std::string_view text) {
  if (text.starts_with("{")) return contentOfJson(text);
  if (text.starts_with("<")) return contentOfMarkup(text);
  if (text.starts_with("ply") && text.size() > 3 && "\r\n \t"sv.find(text[3]) != text.npos)
    return {".ply", {}, {}};
  if (isTextStl(text)) return {".stl", {}, {}};
  if (beginsAsOff(text)) return {".off", {}, {}};
  if (isObj(text)) return {".obj", {}, {}};
  if (isDxf(text)) return {{}, "a DXF file", kExport};
  return {};
}

}  // namespace

Content contentOf(const File& file) {
  const std::string_view bytes = asText(file);
  if (isBinaryStl(bytes, bytes.size())) return {".stl", {}, {}};
  for (const Magic& magic : kMagics)
    if (holdsAt(bytes, magic)) return magic.content;
  if (bytes.starts_with("PK\x03\x04")) return contentOfZip(bytes);
  if (saysLength(bytes, "BM")) return {{}, "a picture (BMP)", kNoModel};
  if (saysLength(bytes, "MM")) return {{}, "a 3DS file", kExport};
  return contentOfText(withoutMarkAndBlanks(bytes));
}

Content contentInBlocks(const File& file) {
  const File begin = beginOf(file, kHeaderLooked);
  if (isBinaryStl(asText(begin), fileSize(file))) return {".stl", {}, {}};
  const Content content = contentOf(begin);
  const bool isRead = content.extension == ".glb" || content.extension == ".obj" ||
                      (content.extension == ".ply" && isBinaryPly(asText(begin)));
  return isRead ? content : Content{};
}

}  // namespace remesher::io
