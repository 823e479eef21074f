// SPDX-License-Identifier: MIT
// A triangle mesh as files and callers know it: plain arrays, no connectivity. Vertices that share
// a position but differ in an attribute (a texture seam, a hard edge) are separate here; the mesh
// builder welds them by position and remembers which corner of which triangle used which.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/types.h"

namespace remesher {

// One value per vertex: `itemSize` numbers each, vertex after vertex. The semantic is glTF's
// (NORMAL, TEXCOORD_0, JOINTS_0, _CUSTOM); a morph target's is prefixed: TARGET_0/POSITION.
struct Attribute {
  std::string semantic;
  int itemSize = 0;
  std::vector<float> values;
};

// The whole numbers as which a file holds coordinates: how many steps of them make one, and how far
// they reach.
struct WholeSteps {
  double perUnit = 1, lowest = 0, highest = 0;

  bool operator==(const WholeSteps&) const = default;
};

struct TriangleMesh {
  std::vector<Vec3> positions;
  std::vector<Index> indices;  // three per triangle, counterclockwise seen from outside
  std::vector<Index> groups;   // one per triangle (a glTF primitive, an OBJ material), or empty
  std::vector<Attribute> attributes;
  bool isSingle = false;  // the coordinates are of single precision, and will be when written
  double scale = 1;       // of the coordinates, over those that are written
  std::optional<WholeSteps> steps = {};  // in which the coordinates were given
  // Triangles 2i and 2i + 1 are a quad each, cut from its first corner: (a, b, c) and (a, c, d).
  bool isQuads = false;

  std::size_t triangleCount() const { return indices.size() / 3; }
};

// A position in single precision, which of the smallest numbers leaves few digits.
inline Vec3 inSingle(const Vec3& p, double scale) {
  return (p / scale).cast<float>().cast<double>() * scale;
}

// Four indices for each quad, in the triangles' order; empty if the mesh is none of quads.
std::vector<Index> quadsOf(const TriangleMesh& mesh);

// Whether each two triangles are cut from one quad as those of a mesh of quads are.
bool arePairs(const TriangleMesh& mesh);

// Null if the mesh has none of this semantic.
const Attribute* findAttribute(const TriangleMesh& mesh, std::string_view semantic);

// One more than the largest group number; one where there are no groups.
std::size_t groupCount(const TriangleMesh& mesh);

// Throws Error: NO_TRIANGLES, INDEX_OUT_OF_RANGE, NON_FINITE, each naming the triangle or vertex.
void requireValid(const TriangleMesh& mesh);

}  // namespace remesher
