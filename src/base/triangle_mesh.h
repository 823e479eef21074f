// SPDX-License-Identifier: MIT
// A triangle mesh as files and callers know it: plain arrays, no connectivity. Vertices that share
// a position but differ in an attribute (a texture seam, a hard edge) are separate here; the mesh
// builder welds them by position and remembers which corner of which triangle used which.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/frame.h"
#include "base/types.h"

namespace remesher {

// One value per vertex: `itemSize` numbers each, vertex after vertex. The semantic is glTF's
// (NORMAL, TEXCOORD_0, JOINTS_0, _CUSTOM); a morph target's is prefixed: TARGET_0/POSITION.
struct Attribute {
  std::string semantic;
  int itemSize = 0;
  std::vector<float> values;
};

// The integer steps in which a file stores coordinates: how many steps make one unit, and their
// range.
struct WholeSteps {
  double perUnit = 1, lowest = 0, highest = 0;

  bool operator==(const WholeSteps&) const = default;
};

struct TriangleMesh {
  std::vector<Vec3> positions;
  std::vector<Index> indices;  // three per triangle, counterclockwise seen from outside
  std::vector<Index> groups;   // one per triangle (a glTF primitive, an OBJ material), or empty
  std::vector<Attribute> attributes;
  bool isSingle = false;                 // coordinates have single precision, and are written so
  Frame frame = {};                      // of the coordinates here
  std::optional<WholeSteps> steps = {};  // the integer steps of the given coordinates, if any
  // Triangles 2i and 2i + 1 are a quad each, cut from its first corner: (a, b, c) and (a, c, d).
  bool isQuads = false;

  std::size_t triangleCount() const { return indices.size() / 3; }
};

// Four indices per quad, in the triangles' order; empty if the mesh has no quads.
std::vector<Index> quadsOf(const TriangleMesh& mesh);

// Whether every two consecutive triangles are cut from one quad like those of a mesh of quads.
bool arePairs(const TriangleMesh& mesh);

// Null if the mesh has no attribute of this semantic.
const Attribute* findAttribute(const TriangleMesh& mesh, std::string_view semantic);

// Whether two vertices have the same value of every attribute.
bool haveSameAttributes(const TriangleMesh& mesh, Index v, Index w);

// Whether they have the same value of every attribute whose semantic `isCompared` accepts.
bool haveSameAttributes(const TriangleMesh& mesh, Index v, Index w,
                        bool (*isCompared)(std::string_view semantic));

// Whether coordinates, triangles, groups and attributes are equal, in the same order; not whether
// they are quads.
bool haveSameContent(const TriangleMesh& a, const TriangleMesh& b);

// Appends the value that a vertex has in `from`, an attribute of as many numbers.
void appendValue(Attribute& to, const Attribute& from, Index vertex);

// The values of some vertices, in their order.
Attribute valuesOf(const Attribute& from, std::span<const Index> vertices);

// Takes the last vertex off. No triangle may use it.
void dropLastVertex(TriangleMesh& mesh);

// One more than the largest group number; one where there are no groups.
std::size_t groupCount(const TriangleMesh& mesh);

// Throws Error: NO_TRIANGLES, INDEX_OUT_OF_RANGE, NON_FINITE, each naming the triangle or vertex.
void requireValid(const TriangleMesh& mesh);

}  // namespace remesher
