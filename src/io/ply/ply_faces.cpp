// SPDX-License-Identifier: MIT
#include "io/ply/ply_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/legible.h"

namespace remesher::io {
namespace {

// Digits of an invalid vertex number in a message: as many as every double holds.
constexpr int kIndexDigits = 15;

// The meaning of a face's property.
enum class Role { Corners, Texcoords, TextureNumber, Ignored };

Role roleOf(const PlyProperty& property) {
  const bool isList = property.countType.has_value();
  if (isList && (property.name == "vertex_indices" || property.name == "vertex_index"))
    return Role::Corners;
  if (isList && property.name == "texcoord" && isFloating(property.type)) return Role::Texcoords;
  if (!isList && property.name == "texnumber") return Role::TextureNumber;
  return Role::Ignored;
}

std::vector<Role> rolesOf(PlyBody& body, const PlyElement& element) {
  std::vector<Role> roles;
  for (const PlyProperty& property : element.properties) roles.push_back(roleOf(property));
  if (element.count > 0 && std::count(roles.begin(), roles.end(), Role::Corners) != 1)
    body.fail(ErrorCode::ParseError,
              "the element \"" + legible(element.name) + "\" has not one list vertex_indices.",
              "Its faces must say which vertices they join.");
  return roles;
}

// The vertex that a number means.
Index vertexAt(PlyBody& body, double number, Index vertexCount) {
  if (number >= 0 && number < vertexCount && number == static_cast<Index>(number))
    return static_cast<Index>(number);
  body.fail(ErrorCode::IndexOutOfRange,
            "a face names vertex " + inDigits(number, kIndexDigits) + ", but there are " +
                std::to_string(vertexCount) + ", counted from 0.",
            "Repair the file: every face may name only vertices that are there.");
}

// One row of an element.
struct Face {
  std::vector<Index> corners;
  std::vector<float> texcoords;
  double textureNumber = 0;
  std::size_t notFinite = 0;  // of this row and those before

  // Values beyond float's range are not finite as floats: they are counted and read as 0.
  double finite(double value) {
    if (std::abs(value) <= double{std::numeric_limits<float>::max()}) return value;
    ++notFinite;
    return 0;
  }
};

void readProperty(PlyBody& body, const PlyProperty& property, Role role, Face& face) {
  if (role == Role::Ignored) {
    body.skip(property);
  } else if (role == Role::TextureNumber) {
    face.textureNumber = face.finite(body.next(property.type, "a texture's number"));
  } else {
    const Index count = body.nextCount(property, "the number of texture coordinates of a face");
    face.texcoords.clear();
    for (Index i = 0; i < count; ++i)
      face.texcoords.push_back(
          static_cast<float>(face.finite(body.next(property.type, "a texture coordinate"))));
  }
}

void readCorners(PlyBody& body, const PlyProperty& list, Index vertexCount, Face& face) {
  const Index count = body.nextCount(list, "the number of corners of a face");
  face.corners.clear();
  for (Index i = 0; i < count; ++i)
    face.corners.push_back(vertexAt(body, body.next(list.type, "a corner of a face"), vertexCount));
}

void append(PlyFaces& faces, const Face& face) {
  faces.notFinite = face.notFinite;
  const std::size_t size = face.corners.size();
  if (size < 3) {
    ++faces.degenerate;
    return;
  }
  if (size > 3 && faces.sizes.empty()) faces.sizes.assign(faces.corners.size() / 3, 3);
  if (size > 3 || !faces.sizes.empty()) faces.sizes.push_back(static_cast<Index>(size));
  faces.corners.insert(faces.corners.end(), face.corners.begin(), face.corners.end());
  faces.cornerTexcoords.insert(faces.cornerTexcoords.end(), face.texcoords.begin(),
                               face.texcoords.end());
}

// A strip alternates the orientation of its triangles. -1 begins another strip. A triangle that
// names a vertex twice only joins strips.
void readStrip(PlyBody& body, const PlyProperty& list, Index vertexCount, PlyFaces& faces) {
  const Index count = body.nextCount(list, "the length of a triangle strip");
  std::array<Index, 3> last{};
  std::size_t length = 0;
  for (Index i = 0; i < count; ++i) {
    const double number = body.next(list.type, "a vertex of a triangle strip");
    if (number == -1) {
      length = 0;
      continue;
    }
    last = {last[1], last[2], vertexAt(body, number, vertexCount)};
    const auto [a, b, c] = last;
    if (++length < 3 || a == b || b == c || c == a) continue;
    for (const Index corner : {length % 2 == 1 ? a : b, length % 2 == 1 ? b : a, c})
      faces.corners.push_back(corner);
  }
}

// Texture coordinates are dropped unless every corner has them.
void settle(PlyFaces& faces, const PlyElement& element, const std::vector<Role>& roles) {
  const bool isComplete = faces.cornerTexcoords.size() == 2 * faces.corners.size();
  if (!isComplete) faces.cornerTexcoords.clear();
  for (std::size_t i = 0; i < roles.size(); ++i)
    if (roles[i] == Role::Ignored || (roles[i] == Role::Texcoords && !isComplete))
      faces.ignored.push_back(element.properties[i].name);
}

}  // namespace

PlyFaces readFaces(PlyBody& body, const PlyElement& element, Index vertexCount) {
  body.requireRows(element);
  const std::vector<Role> roles = rolesOf(body, element);
  PlyFaces faces;
  // A triangle takes at least eight bytes in text, and rarely less in a binary file.
  const auto expected =
      static_cast<std::size_t>(std::min<std::uint64_t>(element.count, body.left() / 8));
  faces.corners.reserve(3 * expected);
  const bool hasNumbers = std::find(roles.begin(), roles.end(), Role::TextureNumber) != roles.end();
  Face face;
  for (Index row = 0; row < element.count; ++row) {
    for (std::size_t i = 0; i < roles.size(); ++i) {
      if (roles[i] == Role::Corners)
        readCorners(body, element.properties[i], vertexCount, face);
      else
        readProperty(body, element.properties[i], roles[i], face);
    }
    append(faces, face);
    if (hasNumbers && face.corners.size() >= 3) faces.textureNumbers.push_back(face.textureNumber);
  }
  settle(faces, element, roles);
  return faces;
}

PlyFaces readStrips(PlyBody& body, const PlyElement& element, Index vertexCount) {
  body.requireRows(element);
  const std::vector<Role> roles = rolesOf(body, element);
  PlyFaces faces;
  for (Index row = 0; row < element.count; ++row) {
    for (std::size_t i = 0; i < roles.size(); ++i) {
      if (roles[i] == Role::Corners)
        readStrip(body, element.properties[i], vertexCount, faces);
      else
        body.skip(element.properties[i]);
    }
  }
  return faces;
}

}  // namespace remesher::io
