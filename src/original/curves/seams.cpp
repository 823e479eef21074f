// SPDX-License-Identifier: MIT
#include "original/curves/seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/legible.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

// A surface that bends by less counts as smooth, whatever the normals say.
const double kBlunt = std::cos(radians(5));
// Values closer than this are one value: the step of a 16-bit normalised integer.
constexpr float kQuantum = 1.0F / 65535;

bool followsShading(const std::string& semantic) {
  return semantic.find("NORMAL") != std::string::npos ||
         semantic.find("TANGENT") != std::string::npos;
}

bool differ(const Attribute& attribute, Index a, Index b) {
  if (a == b) return false;
  for (int k = 0; k < attribute.itemSize; ++k) {
    const float x = attribute.values[std::size_t{a} * attribute.itemSize + k];
    const float y = attribute.values[std::size_t{b} * attribute.itemSize + k];
    if (std::abs(x - y) > kQuantum * std::max(1.0F, std::abs(x))) return true;
  }
  return false;
}

bool bends(const BuiltMesh& built, Halfedge h, double cosAngle) {
  const auto normal = [&](Face f) {
    const auto [a, b, c] = built.mesh.vertices(f);
    return unitNormal(built.positions[a], built.positions[b], built.positions[c]);
  };
  const HalfedgeMesh& mesh = built.mesh;
  return normal(mesh.face(h)).dot(normal(mesh.face(mesh.twin(h)))) < cosAngle;
}

// Whether the attribute has different values on the two sides at the origin of h.
bool jumpsAtOrigin(const BuiltMesh& built, const Attribute& attribute, Halfedge h) {
  const HalfedgeMesh& mesh = built.mesh;
  return differ(attribute, built.wedges[h], built.wedges[mesh.next(mesh.twin(h))]);
}

// The same, at either end of the edge.
bool jumps(const BuiltMesh& built, const Attribute& attribute, Halfedge h) {
  return jumpsAtOrigin(built, attribute, h) || jumpsAtOrigin(built, attribute, built.mesh.twin(h));
}

// Without the edges that jump at one end only, where several others do so, too.
std::vector<Halfedge> withoutPoles(const BuiltMesh& built, const Attribute& attribute,
                                   std::vector<Halfedge> edges) {
  constexpr Index kMostEnds = 2;  // seams may end there
  const auto onlyEnd = [&](Halfedge h) {
    const Halfedge twin = built.mesh.twin(h);
    const bool isAtOrigin = jumpsAtOrigin(built, attribute, h);
    if (isAtOrigin == jumpsAtOrigin(built, attribute, twin)) return Vertex();
    return built.mesh.origin(isAtOrigin ? h : twin);
  };
  VertexData<Index> ends(built.mesh.vertexCapacity(), 0);
  for (const Halfedge h : edges)
    if (const Vertex v = onlyEnd(h)) ++ends[v];
  std::erase_if(edges, [&](Halfedge h) {
    const Vertex v = onlyEnd(h);
    return v && ends[v] > kMostEnds;
  });
  return edges;
}

bool isTexture(const Attribute& attribute) {
  return attribute.itemSize == 2 && attribute.semantic.rfind("TEXCOORD_", 0) == 0;
}

// Twice the signed area of a face in texture coordinates.
double areaIn(const BuiltMesh& built, const Attribute& texture, Face f) {
  std::array<Vec2, 3> at;
  for (int i = 0; i < 3; ++i) {
    const float* uv = &texture.values[std::size_t{2} * built.wedges[HalfedgeMesh::halfedge(f, i)]];
    at[i] = {uv[0], uv[1]};
  }
  const Vec2 a = at[1] - at[0], b = at[2] - at[0];
  return a.x() * b.y() - a.y() * b.x();
}

// Whether the texture turns back at the edge, as where both halves of a model share one texture. A
// triangle across such an edge would skip the texture between its corners.
bool mirrors(const BuiltMesh& built, const Attribute& texture, Halfedge h) {
  return areaIn(built, texture, built.mesh.face(h)) *
             areaIn(built, texture, built.mesh.face(built.mesh.twin(h))) <
         0;
}

// The edges where the shading jumps, but at one end of which most edges do not jump: these are
// intended lines, not facets.
std::vector<Halfedge> linesAmong(const HalfedgeMesh& mesh, const std::vector<Halfedge>& edges) {
  VertexData<Index> jumping(mesh.vertexCapacity(), 0);
  for (const Halfedge h : edges)
    for (const Vertex v : {mesh.origin(h), mesh.tip(h)}) ++jumping[v];
  const auto areFew = [&](Vertex v) { return int(2 * jumping[v]) <= mesh.valence(v); };
  std::vector<Halfedge> lines;
  for (const Halfedge h : edges)
    if (areFew(mesh.origin(h)) || areFew(mesh.tip(h))) lines.push_back(h);
  return lines;
}

struct Edges {
  std::vector<Halfedge> inner;
  double cosHardNormal;
  Poles poles;
};

void addAttributeSeams(const BuiltMesh& built, const Attribute& attribute, const Edges& edges,
                       Seams& seams) {
  std::vector<Halfedge> found;
  for (const Halfedge h : edges.inner)
    if (jumps(built, attribute, h)) found.push_back(h);
  const bool shading = followsShading(attribute.semantic);
  // An attribute that jumps at most edges has no charts to preserve.
  if (2 * found.size() > edges.inner.size()) {
    seams.chartless.push_back(attribute.semantic);
    // Normals that jump everywhere (flat shading) say no more than the surface itself.
    if (shading) return;
    seams.warnings.push_back({"ATTRIBUTE_HAS_NO_CHARTS",
                              legible(attribute.semantic) +
                                  " jumps across most edges: it is carried by the nearest corner.",
                              found.size()});
    return;
  }
  if (!shading) seams.jumps.insert(seams.jumps.end(), found.begin(), found.end());
  if (!shading && edges.poles == Poles::Left)
    found = withoutPoles(built, attribute, std::move(found));
  for (const Halfedge h : found)
    if (!shading || bends(built, h, edges.cosHardNormal)) seams.edges.push_back(h);
  if (shading)
    for (const Halfedge h : linesAmong(built.mesh, found))
      if (bends(built, h, kBlunt) && !bends(built, h, edges.cosHardNormal))
        seams.edges.push_back(h);
  if (!isTexture(attribute)) return;
  for (const Halfedge h : edges.inner)
    if (mirrors(built, attribute, h)) seams.edges.push_back(h);
}

}  // namespace

Seams findSeams(const BuiltMesh& built, const TriangleMesh& input, double hardNormalAngle,
                Poles poles) {
  const HalfedgeMesh& mesh = built.mesh;
  Seams seams;
  if (input.groups.empty() && input.attributes.empty()) return seams;
  Edges edges{{}, std::cos(radians(hardNormalAngle)), poles};
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i)
    if (mesh.isEdge(Halfedge(i)) && !mesh.isBoundary(Halfedge(i)))
      edges.inner.push_back(Halfedge(i));
  const auto group = [&](Halfedge h) { return input.groups[built.triangles[mesh.face(h)]]; };
  if (!input.groups.empty())
    for (const Halfedge h : edges.inner)
      if (group(h) != group(mesh.twin(h))) seams.borders.push_back(h);
  for (const Attribute& attribute : input.attributes)
    addAttributeSeams(built, attribute, edges, seams);
  return seams;
}

}  // namespace remesher
