// SPDX-License-Identifier: MIT
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "base/legible.h"
#include "geometry/polygon.h"
#include "io/model/resources.h"
#include "io/named/named_faces.h"
#include "io/named/vtu.h"
#include "io/text/text_scanner.h"
#include "io/text/xml_scanner.h"

namespace remesher::io {
namespace {

template <class Number>
void appendNumbers(std::span<const std::uint8_t> bytes, std::vector<double>& numbers) {
  static_assert(std::endian::native == std::endian::little);
  numbers.reserve(bytes.size() / sizeof(Number));
  for (std::size_t i = 0; i + sizeof(Number) <= bytes.size(); i += sizeof(Number)) {
    Number number;
    std::memcpy(&number, &bytes[i], sizeof(Number));
    numbers.push_back(static_cast<double>(number));
  }
}

// Whether the type is known.
bool appendTyped(std::string_view type, std::span<const std::uint8_t> bytes,
                 std::vector<double>& numbers) {
  if (type == "Float32") return appendNumbers<float>(bytes, numbers), true;
  if (type == "Float64") return appendNumbers<double>(bytes, numbers), true;
  if (type == "Int8") return appendNumbers<std::int8_t>(bytes, numbers), true;
  if (type == "UInt8") return appendNumbers<std::uint8_t>(bytes, numbers), true;
  if (type == "Int16") return appendNumbers<std::int16_t>(bytes, numbers), true;
  if (type == "UInt16") return appendNumbers<std::uint16_t>(bytes, numbers), true;
  if (type == "Int32") return appendNumbers<std::int32_t>(bytes, numbers), true;
  if (type == "UInt32") return appendNumbers<std::uint32_t>(bytes, numbers), true;
  if (type == "Int64") return appendNumbers<std::int64_t>(bytes, numbers), true;
  if (type == "UInt64") return appendNumbers<std::uint64_t>(bytes, numbers), true;
  return false;
}

class VtuReader {
 public:
  VtuReader(std::string_view text, const std::string& name)
      : text_(text), xml_(text, name), name_(name) {}
  Model read();

 private:
  struct Piece {
    std::vector<double> points, connectivity, offsets, types, groups;
  };

  void beginFile(const XmlTag& tag);
  std::vector<double> arrayOf(const XmlTag& tag);
  std::vector<double> inText(std::string_view text) const;
  std::vector<std::uint8_t> decoded(std::string_view text) const;
  std::span<const std::uint8_t> payloadOf(std::span<const std::uint8_t> bytes) const;
  void take(const XmlTag& tag, Piece& piece);
  void readNames(const std::vector<double>& letters);
  void addPiece(const Piece& piece);
  void addCell(int type, std::vector<Index> corners, Index set);
  Index indexIn(double value, std::size_t end, std::string_view what) const;

  std::string_view text_;
  XmlScanner xml_;
  std::string name_;
  std::string section_;  // the element around arrays
  std::size_t headerBytes_ = 4;
  std::size_t appendedAt_ = 0;  // the first byte behind its underscore; 0: none
  bool isAppendedRaw_ = false;
  std::size_t others_ = 0;  // cells that are no faces
  NamedFaces surface_;
};

void VtuReader::beginFile(const XmlTag& tag) {
  if (tag.get("type") != "UnstructuredGrid" && tag.get("type") != "PolyData")
    xml_.fail(ErrorCode::Unsupported, "the file holds VTK's " + legible(tag.get("type")) + ".",
              "Save an unstructured grid (.vtu).");
  if (tag.find("compressor") != nullptr)
    xml_.fail(ErrorCode::Unsupported, "its arrays are compressed.",
              "Save it without compression, or as text (ASCII).");
  if (tag.get("byte_order") == "BigEndian")
    xml_.fail(ErrorCode::Unsupported, "its arrays have the other order of bytes.",
              "Save it as LittleEndian, or as text (ASCII).");
  headerBytes_ = tag.get("header_type") == "UInt64" ? 8 : 4;
}

std::vector<double> VtuReader::inText(std::string_view text) const {
  TextScanner scanner(text, name_);
  std::vector<double> numbers;
  scanner.nextLine();
  while (scanner.skipEmptyLines()) numbers.push_back(scanner.anyNumber("a number of an array"));
  return numbers;
}

std::vector<std::uint8_t> VtuReader::decoded(std::string_view text) const {
  std::string plain;
  for (const char c : text)
    if (c > ' ') plain += c;
  // Header and data may be coded one after the other, each padded.
  std::vector<std::uint8_t> bytes;
  for (std::size_t at = 0; at < plain.size();) {
    const std::size_t padding = plain.find('=', at);
    const std::size_t end = padding == plain.npos ? plain.size() : (padding / 4 + 1) * 4;
    const auto part = decodeDataUri("data:;base64," + plain.substr(at, end - at));
    if (!part) xml_.fail(ErrorCode::ParseError, "an array is not base64.");
    bytes.insert(bytes.end(), part->begin(), part->end());
    at = end;
  }
  return bytes;
}

// The bytes behind the header, which is their number.
std::span<const std::uint8_t> VtuReader::payloadOf(std::span<const std::uint8_t> bytes) const {
  std::uint64_t length = 0;
  if (bytes.size() < headerBytes_)
    xml_.fail(ErrorCode::ParseError, "an array ends too early.", "Was it copied completely?");
  std::memcpy(&length, bytes.data(), headerBytes_);
  if (length > bytes.size() - headerBytes_)
    xml_.fail(ErrorCode::ParseError, "an array promises more bytes than follow.",
              "Was it copied completely?");
  return bytes.subspan(headerBytes_, static_cast<std::size_t>(length));
}

std::vector<double> VtuReader::arrayOf(const XmlTag& tag) {
  const std::string format = tag.get("format"), type = tag.get("type");
  if (format == "ascii") return inText(xml_.text());
  std::vector<std::uint8_t> coded;
  std::span<const std::uint8_t> payload;
  if (format == "appended") {
    const auto [offset, rest] = TextScanner::leadingInteger(tag.get("offset"));
    if (appendedAt_ == 0 || offset < 0 || std::size_t(offset) > text_.size() - appendedAt_)
      xml_.fail(ErrorCode::ParseError, "an appended array lies outside of the file.");
    std::string_view from = text_.substr(appendedAt_ + std::size_t(offset));
    if (!isAppendedRaw_) from = from.substr(0, std::min(from.find('<'), from.size()));
    if (!isAppendedRaw_) {
      // Each array is coded for itself, so that the text up to the end is enough, and too much.
      const std::size_t header = (headerBytes_ + 2) / 3 * 4;
      const std::vector<std::uint8_t> head = decoded(from.substr(0, header));
      std::uint64_t length = 0;
      std::memcpy(&length, head.data(), std::min(headerBytes_, head.size()));
      const std::uint64_t letters = (length + headerBytes_ + 2) / 3 * 4 + 8;
      coded = decoded(from.substr(0, std::size_t(std::min<std::uint64_t>(letters, from.size()))));
      payload = payloadOf(coded);
    } else {
      payload = payloadOf({reinterpret_cast<const std::uint8_t*>(from.data()), from.size()});
    }
  } else {
    coded = decoded(xml_.text());
    payload = payloadOf(coded);
  }
  std::vector<double> numbers;
  if (!appendTyped(type == "String" ? "UInt8" : type, payload, numbers))
    xml_.fail(ErrorCode::Unsupported, "an array is of type " + legible(type) + ".");
  return numbers;
}

void VtuReader::readNames(const std::vector<double>& letters) {
  std::string name;
  for (const double letter : letters) {
    if (letter == 0) {
      surface_.names.push_back(std::exchange(name, {}));
    } else {
      name += static_cast<char>(letter);
    }
  }
}

void VtuReader::take(const XmlTag& tag, Piece& piece) {
  const std::string array = tag.get("Name");
  if (section_ == "FieldData" && array == "groupNames") readNames(arrayOf(tag));
  if (section_ == "Points") piece.points = arrayOf(tag);
  if (section_ == "Cells" && array == "connectivity") piece.connectivity = arrayOf(tag);
  if (section_ == "Cells" && array == "offsets") piece.offsets = arrayOf(tag);
  if (section_ == "Cells" && array == "types") piece.types = arrayOf(tag);
  if (section_ == "Polys" && array == "connectivity") piece.connectivity = arrayOf(tag);
  if (section_ == "Polys" && array == "offsets") piece.offsets = arrayOf(tag);
  if (section_ == "CellData" && array == "group") piece.groups = arrayOf(tag);
}

Index VtuReader::indexIn(double value, std::size_t end, std::string_view what) const {
  if (!(value >= 0 && value < double(end)) || value != std::floor(value))
    xml_.fail(ErrorCode::IndexOutOfRange,
              std::string(what) + " is " + inDigits(value, 17) + ", but there are " +
                  std::to_string(end) + ", counted from 0.",
              "Repair the file: every cell may name only points that are there.");
  return static_cast<Index>(value);
}

void VtuReader::addCell(int type, std::vector<Index> corners, Index set) {
  const auto add = [&](std::vector<Index> face) {
    NamedFaces::Face added{{}, static_cast<Index>(face.size()), set};
    std::copy(face.begin(), face.end(), added.corners.begin());
    surface_.faces.push_back(added);
  };
  const std::size_t needed =
      type == kVtkTriangle || type == kVtkTriangleOfSix || type == kVtkStrip || type == kVtkPolygon
          ? 3
          : 4;
  if (corners.size() < needed) return;
  if (type == kVtkTriangle || type == kVtkTriangleOfSix) {
    add({corners[0], corners[1], corners[2]});
  } else if (type == kVtkQuad || type == kVtkQuadOfEight || type == kVtkQuadOfNine) {
    add({corners[0], corners[1], corners[2], corners[3]});
  } else if (type == kVtkPixel) {
    add({corners[0], corners[1], corners[3], corners[2]});
  } else if (type == kVtkStrip) {
    for (std::size_t i = 2; i < corners.size(); ++i)
      add({corners[i - 2 + i % 2], corners[i - 1 - i % 2], corners[i]});
  } else if (corners.size() <= 4) {
    add(std::move(corners));
  } else {
    std::vector<Vec3> points;
    for (const Index corner : corners) points.push_back(surface_.positions[corner]);
    for (const auto& [a, b, c] : triangulate(points)) add({corners[a], corners[b], corners[c]});
  }
}

bool isFace(int type) {
  return type == kVtkTriangle || type == kVtkStrip || type == kVtkPolygon || type == kVtkPixel ||
         type == kVtkQuad || type == kVtkTriangleOfSix || type == kVtkQuadOfEight ||
         type == kVtkQuadOfNine;
}

void VtuReader::addPiece(const Piece& piece) {
  const std::size_t first = surface_.positions.size(), count = piece.points.size() / 3;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 point(piece.points[3 * i], piece.points[3 * i + 1], piece.points[3 * i + 2]);
    if (!point.allFinite())
      xml_.fail(ErrorCode::NonFinite, "a point is not finite.",
                "Repair the file: every coordinate must be a finite number.");
    surface_.positions.push_back(point);
  }
  std::size_t begin = 0;
  for (std::size_t cell = 0; cell < piece.offsets.size(); ++cell) {
    const std::size_t end =
        indexIn(piece.offsets[cell], piece.connectivity.size() + 1, "an offset");
    const int type = cell < piece.types.size() ? int(piece.types[cell]) : int(kVtkPolygon);
    if (!isFace(type)) {
      constexpr int kLine = 3;
      others_ += type > kLine;
      begin = end;
      continue;
    }
    std::vector<Index> corners;
    for (; begin < end; ++begin)
      corners.push_back(Index(first) + indexIn(piece.connectivity[begin], count, "a corner"));
    const bool isNamed = cell < piece.groups.size() && !surface_.names.empty();
    addCell(type, std::move(corners),
            isNamed ? indexIn(piece.groups[cell], surface_.names.size(), "a group") : 0);
  }
}

Model VtuReader::read() {
  const std::size_t appended = text_.find("<AppendedData");
  if (appended != text_.npos) {
    const std::size_t end = std::min(text_.find('>', appended), text_.size());
    appendedAt_ = std::min(text_.find('_', end), text_.size() - 1) + 1;
    isAppendedRaw_ = text_.substr(appended, end - appended).find("raw") != text_.npos;
  }
  Piece piece;
  while (const std::optional<XmlTag> tag = xml_.next()) {
    if (tag->name == "AppendedData") break;
    if (tag->name == "VTKFile" && tag->opens) beginFile(*tag);
    if (tag->name == "DataArray" && tag->opens)
      take(*tag, piece);
    else if (tag->name == "Piece" && tag->closes)
      addPiece(std::exchange(piece, {}));
    else if (tag->opens)
      section_ = std::string(tag->name);
  }
  if (surface_.names.empty()) surface_.names.emplace_back();
  Model model = modelOf(std::move(surface_), name_);
  if (others_ > 0)
    model.warnings.push_back({"ELEMENTS_LEFT_OUT",
                              "Cells that are no faces, such as tetrahedra, are left out: only "
                              "surfaces are remeshed.",
                              others_});
  return model;
}

}  // namespace

Model readVtu(const File& file, const std::vector<File>&) {
  return VtuReader(asText(file), file.name).read();
}

}  // namespace remesher::io
