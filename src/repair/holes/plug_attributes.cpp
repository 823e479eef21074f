// SPDX-License-Identifier: MIT
#include "repair/holes/plug_attributes.h"

#include <map>

#include "geometry/triangle.h"
#include "mesh/attribute_mix.h"

namespace remesher {

namespace {

Index groupAt(const KeptSurface& kept, Halfedge h) {
  const std::vector<Index>& groups = kept.mesh.groups;
  return groups.empty() ? 0 : groups[kept.built.triangles[HalfedgeMesh::face(h)]];
}

Index groupOfLoop(const KeptSurface& kept, const Loop& loop) {
  const BuiltMesh& built = kept.built;
  std::map<Index, double> lengths;
  for (const Halfedge h : loop.across)
    lengths[groupAt(kept, h)] +=
        distance(built.positions[built.mesh.origin(h)], built.positions[built.mesh.tip(h)]);
  auto longest = lengths.begin();
  for (auto it = lengths.begin(); it != lengths.end(); ++it)
    if (it->second > longest->second) longest = it;
  return longest->first;
}

// The vertex that triangles of the group have at a vertex of the surface, or kNone.
Index wedgeOfGroup(const KeptSurface& kept, Vertex v, Index group) {
  Index wedge = kNone;
  kept.built.mesh.forEachOutgoing(v, [&](Halfedge h) {
    if (wedge == kNone && groupAt(kept, h) == group) wedge = kept.built.wedges[h];
  });
  return wedge;
}

Index copyVertex(TriangleMesh& mesh, Index source, const Vec3& place) {
  mesh.positions.push_back(place);
  for (Attribute& attribute : mesh.attributes)
    for (int k = 0; k < attribute.itemSize; ++k)
      attribute.values.push_back(attribute.values[std::size_t{source} * attribute.itemSize + k]);
  return Index(mesh.positions.size() - 1);
}

// Per vertex of a ring one with the group's attributes. Where the group has none, a new vertex
// copies the last one before it along the ring; a ring without any, as the inner one of a lid whose
// walls have different materials, keeps the attributes of its own wall.
void addRing(std::vector<Index>& result, TriangleMesh& mesh, const KeptSurface& kept,
             const Loop& loop, std::size_t end, Index group) {
  const std::size_t begin = result.size();
  Index last = kNone;
  for (std::size_t i = begin; i < end; ++i) {
    result.push_back(wedgeOfGroup(kept, loop.vertices[i], group));
    if (result.back() != kNone) last = result.back();
  }
  for (std::size_t i = begin; i < end; ++i) {
    if (result[i] != kNone) {
      last = result[i];
      continue;
    }
    const Index own = kept.built.wedges[HalfedgeMesh::next(loop.across[i])];
    result[i] =
        copyVertex(mesh, last == kNone ? own : last, kept.built.positions[loop.vertices[i]]);
  }
}

std::vector<Index> rimVertices(TriangleMesh& mesh, const KeptSurface& kept, const Loop& loop,
                               Index group) {
  std::vector<Index> result;
  for (const Index begin : loop.inner) addRing(result, mesh, kept, loop, begin, group);
  addRing(result, mesh, kept, loop, loop.vertices.size(), group);
  return result;
}

bool isNormal(const Attribute& attribute) {
  return attribute.semantic == "NORMAL" && attribute.itemSize == 3;
}

// Per vertex of the plug, the area-weighted normal of the plug's triangles around it.
std::vector<Vec3> normalsOf(const Plug& plug) {
  std::vector<Vec3> normals(plug.points.size(), Vec3::Zero());
  for (const Corners3& t : plug.triangles) {
    const Vec3 vector = areaVector(plug.points[t[0]], plug.points[t[1]], plug.points[t[2]]);
    for (const Index v : t) normals[v] += vector;
  }
  for (Vec3& normal : normals) normal = normal.stableNormalized();
  return normals;
}

void setNormal(Attribute& attribute, Index vertex, const Vec3& normal) {
  if (normal.isZero(0)) return;
  for (int k = 0; k < 3; ++k) attribute.values[std::size_t{3} * vertex + k] = float(normal[k]);
}

}  // namespace

void appendPlug(TriangleMesh& mesh, const KeptSurface& kept, const Loop& loop, const Plug& plug) {
  const Index group = groupOfLoop(kept, loop);
  std::vector<Index> vertices = rimVertices(mesh, kept, loop, group);
  const std::size_t rim = vertices.size();
  const std::vector<Vec3> normals = normalsOf(plug);
  const AttributeMix mixed(mesh);
  for (std::size_t i = rim; i < plug.points.size(); ++i) {
    const Corners3& p = plug.parents[i - rim];
    const std::array<Index, 3> parents = {vertices[p[0]], vertices[p[1]], vertices[p[2]]};
    vertices.push_back(Index(mesh.positions.size()));
    mesh.positions.push_back(plug.points[i]);
    mixed.append({parents, Vec3::Constant(1.0 / 3), normals[i]}, mesh.attributes);
    for (Attribute& attribute : mesh.attributes)
      if (isNormal(attribute)) setNormal(attribute, vertices.back(), normals[i]);
  }
  for (const Corners3& t : plug.triangles) {
    for (const Index v : t) mesh.indices.push_back(vertices[v]);
    if (!mesh.groups.empty()) mesh.groups.push_back(group);
  }
}

}  // namespace remesher
