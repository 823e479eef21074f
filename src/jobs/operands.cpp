// SPDX-License-Identifier: MIT
#include "jobs/operands.h"

#include <algorithm>
#include <set>
#include <utility>

#include "geometry/triangle.h"
#include "io/model/appending.h"
#include "jobs/checks/repair_room.h"
#include "jobs/run_guards.h"

namespace remesher {

namespace {

using Parts = std::vector<io::Part>;

bool isOfSkin(const std::string& semantic) {
  return semantic.starts_with("JOINTS_") || semantic.starts_with("WEIGHTS_");
}

bool areAllWith(const Parts& parts, const std::string& semantic) {
  return std::all_of(parts.begin(), parts.end(), [&](const io::Part& part) {
    return findAttribute(part.mesh, semantic) != nullptr;
  });
}

// Leaves out the attributes whose numbers mean nothing beside the other operand's.
std::vector<Warning> dropMotion(Parts& parts, Carried carried) {
  std::set<std::string> dropped;
  for (const io::Part& part : parts)
    for (const Attribute& attribute : part.mesh.attributes) {
      const std::string& semantic = attribute.semantic;
      const bool isForeign = carried == Carried::Arrays
                                 ? isOfSkin(semantic) && !areAllWith(parts, semantic)
                                 : isOfSkin(semantic) || semantic.starts_with("TARGET_");
      if (isForeign) dropped.insert(semantic);
    }
  for (io::Part& part : parts)
    std::erase_if(part.mesh.attributes, [&](const Attribute& attribute) {
      return dropped.count(attribute.semantic) > 0;
    });
  if (dropped.empty()) return {};
  return {{"ATTRIBUTE_NOT_CARRIED",
           "Joints, weights and morph targets are not carried: the other operand has none for "
           "them.",
           dropped.size()}};
}

// Each triangle with vertices of its own, which have its normal.
TriangleMesh withFlatNormals(const TriangleMesh& mesh) {
  TriangleMesh flat = mesh;
  flat.positions.clear();
  for (Attribute& attribute : flat.attributes) attribute.values.clear();
  Attribute normals{"NORMAL", 3, {}};
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const Index v = mesh.indices[i];
    const Index* corners = &mesh.indices[i - i % 3];
    flat.indices[i] = Index(i);
    flat.positions.push_back(mesh.positions[v]);
    for (std::size_t a = 0; a < mesh.attributes.size(); ++a) {
      const auto from =
          mesh.attributes[a].values.begin() + std::ptrdiff_t(v) * mesh.attributes[a].itemSize;
      flat.attributes[a].values.insert(flat.attributes[a].values.end(), from,
                                       from + mesh.attributes[a].itemSize);
    }
    const Vec3 normal = areaVector(mesh.positions[corners[0]], mesh.positions[corners[1]],
                                   mesh.positions[corners[2]])
                            .stableNormalized();
    for (int k = 0; k < 3; ++k) normals.values.push_back(float(normal[k]));
  }
  flat.attributes.push_back(std::move(normals));
  return flat;
}

// A mesh without normals is shown flat: beside one with normals it gets those.
void giveNormals(Parts& parts) {
  const auto hasNormals = [](const io::Part& part) {
    return findAttribute(part.mesh, "NORMAL") != nullptr;
  };
  if (std::none_of(parts.begin(), parts.end(), hasNormals)) return;
  for (io::Part& part : parts)
    if (!hasNormals(part)) part.mesh = withFlatNormals(part.mesh);
}

// One entry per group; each also names the attributes that only other parts have.
void noteGroups(Parts& parts) {
  std::set<std::string> semantics;
  for (const io::Part& part : parts)
    for (const Attribute& attribute : part.mesh.attributes) semantics.insert(attribute.semantic);
  for (io::Part& part : parts) {
    part.groups.resize(groupCount(part.mesh));
    for (const std::string& semantic : semantics)
      if (!findAttribute(part.mesh, semantic))
        for (io::GroupInfo& group : part.groups) group.lacks.push_back(semantic);
  }
}

// Parts from `begin` to `end` as one; its groups are appended to all.
io::Part asOne(const Parts& parts, std::pair<std::size_t, std::size_t> range,
               std::vector<io::GroupInfo>& groups) {
  io::Part one{parts[range.first].name, {}, {Transform::Identity()}};
  one.mesh.isSingle = true;
  for (std::size_t i = range.first; i < range.second; ++i) {
    appendGroups(one.mesh.groups, parts[i].mesh, Index(groups.size()));
    appendMesh(one.mesh, parts[i].mesh);
    one.mesh.isSingle = one.mesh.isSingle && parts[i].mesh.isSingle;
    groups.insert(groups.end(), parts[i].groups.begin(), parts[i].groups.end());
  }
  return one;
}

}  // namespace

OperandPair pairOf(const std::array<GivenOperand, 2>& given, Carried carried, double addresses) {
  double triangles = 0;
  for (const GivenOperand& operand : given)
    for (const io::Part& part : operand.parts) triangles += double(part.mesh.triangleCount());
  requireRoomForTwo({triangles, kCombineBytes * triangles}, "combine", addresses);
  Parts all;
  for (const GivenOperand& operand : given) {
    for (const io::Part& part : operand.parts)
      inFile(operand.name, [&] { requireValid(part.mesh); });
    all.insert(all.end(), operand.parts.begin(), operand.parts.end());
  }
  const bool isGrouped =
      carried == Carried::Scene ||
      (carried == Carried::Arrays && std::any_of(all.begin(), all.end(), [](const io::Part& part) {
         return !part.mesh.groups.empty();
       }));
  OperandPair pair;
  pair.warnings = dropMotion(all, carried);
  giveNormals(all);
  noteGroups(all);
  const std::size_t first = given[0].parts.size();
  pair.parts[0] = asOne(all, {0, first}, pair.groups);
  pair.parts[1] = asOne(all, {first, all.size()}, pair.groups);
  const bool isSingle = pair.parts[0].mesh.isSingle && pair.parts[1].mesh.isSingle;
  for (std::size_t i = 0; i < 2; ++i) {
    pair.names[i] = given[i].name;
    pair.parts[i].mesh.isSingle = isSingle;
    if (!isGrouped) pair.parts[i].mesh.groups.clear();
  }
  if (!isGrouped) pair.groups.clear();
  return pair;
}

TriangleMesh joinedOperands(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh both = a;
  both.isQuads = false;
  if (!a.groups.empty()) appendGroups(both.groups, b, 0);
  appendMesh(both, b);
  return both;
}

}  // namespace remesher
