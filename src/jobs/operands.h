// SPDX-License-Identifier: MIT
// The operands of a Boolean as two meshes with the same attributes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/report.h"
#include "base/room.h"
#include "io/model/model.h"

namespace remesher {

// An operand as it is given: parts in the world, under the same conventions as the other's.
struct GivenOperand {
  std::string name;  // for messages
  std::vector<io::Part> parts;
};

// The attributes that the result can hold.
enum class Carried {
  Arrays,  // everything; groups if an operand has any
  Scene,   // groups, and no attributes of skins and morph targets
  Solid,   // as Scene, without groups
};

struct OperandPair {
  std::array<std::string, 2> names;
  std::array<io::Part, 2> parts;
  std::vector<io::GroupInfo> groups;  // those of the second follow those of the first
  std::vector<Warning> warnings;
};

// Each operand's parts as one mesh. Attributes that some lack get their default (see appendMesh),
// and normals those of flat triangles. Throws the Errors of requireValid, and OUT_OF_MEMORY if
// there is no room for a Boolean.
OperandPair pairOf(const std::array<GivenOperand, 2>& given, Carried carried,
                   double addresses = kAddresses);

// Both meshes as one: the triangles of the first, then those of the second.
TriangleMesh joinedOperands(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace remesher
